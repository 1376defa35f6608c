//! How are the presets' unit cubes bisected? Reads nothing; writes nothing, keeps what a search found.
//!
//! Made by `cargo run --release -p carom-tables --example certify bisections > tables/src/recipe/bisections.rs`.
//! An unoptimised build script has no time for the search; the table that a kept bisection gives is certified all the same.

pub(super) const STANDARD_LINEAR: &str = "\
    01012kek0kekkek12kekkek2kekkek12kek0kekkek2kekkek0112kekkek2kekkek12kekkek2kekkek12kekkek2\
    kek0kekkek0210kekkekkek1kekkek20kek2kekkek0kek0kek2kekkek\
    ";

pub(super) const WIDE_LINEAR: &str = "\
    1102geg2ieg0geggeg02geggek2geg2kegieg102ieg0geg2geggeg2iegkei02000220geggig0geggig0gegggg1\
    geiggg2ggggig2gggggg0021gegieg1gegieggeggeg220geg0geg0geggeg02geggegkeg2keg2meg2oeg2oeggeg\
    1210100020geg1ggggig0geg0geggig2gkgggg2gggggg2geggeg0000geg0geg2gggggk2ggg2gegggg21geggegg\
    eg2geggeg20geg0geg0gegiegoeg2002mgg2mgggegggg20geg0gegqeg0gegmeg0210ieggeg10iekgeg2keggeg0\
    0212imgimggeggigggggegoeg00000geg0geg22211ggggigggg211gggggggeg11gggggggeg121ggggeg1ggggeg\
    geggeg2220211gggggggeg11gigggggeg11gegggggeg211gggggggeg11gggggggeg0211gggggggeg11ggggeg1g\
    eggeg211ggggeggeg1giggeg2201giggeggiggeggeg2201ggggeggig021ggggeggggggg1geggegggg2meg2meg2\
    oegoeg0220021geg0geg2geg22ggg2gig1geggig211geggeggig1geggig2220gmg1geggmg0gkg21geggmg1gegg\
    mg0gmg1ggg2gkggig20geg1gigggg1giggeg12gegggi22ggg22ggg2giggig21geggig1gegggg221gggggggigge\
    g221gegggg22gig1geggig1gegggg21gegggggig222000geg1giggeg1ggggegggg1ikggegggggggggg022222ge\
    gggggggggggggggg0222221geg0geggeggeggggggggggggg02222ggggeggeggeggeg2ieg2gegieg\
    ";

pub(super) const STANDARD_VISCOELASTIC: &str = "\
    01012kekkek2kekkek21kekkekkek012kekkek21kekkekkek21kekkekkek0210kekkek0kekkek10kekkekkek20\
    kekkek0kekkek\
    ";

pub(super) const WIDE_VISCOELASTIC: &str = "\
    0001202geggeg2geggeg20keggeg00002meg00002kegkeggeggeggeggeggeg2geggeggeggeg2002000igggeggg\
    gggggeggeigei002geg0002gegoei2geggeggeggeggeggeg22ggggggggk22geggeggek2202geggeg2220gegkek\
    geggeggeggeg2geg20geggeg0geg0gei2ieg0gei2ieg0gei2iegmei\
    ";
