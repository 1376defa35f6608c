//! How are the presets' unit cubes bisected? Reads nothing; writes nothing, keeps what a search found.
//!
//! Made by `cargo run --release -p carom-tables --example certify plans > tables/src/recipe/plan.rs`.
//! An unoptimised build script has no time for the search; what a plan gives is certified all the same.

pub(super) const STANDARD_LINEAR: &str = "\
    01012kekkek12kekkek20kekkekkek12kekkek2kekkek0112kekkek2kekkek12kekkek2kekkek120kekkekkek2\
    kekkek021kekkek1kek0kekkek22kek0kekkek0kek0kek2kekkek\
    ";

pub(super) const WIDE_LINEAR: &str = "\
    1102gegiei02geggei2gei2megieg120geikei00geg2geggegkei00200220geggig0geggig0gegggggig2ggggi\
    g0020gegkggigg1geggeigei22gggggggeg220geg0geg0geg0geggeg0gegkeg2meg2meg2oeg2ieggeg12101000\
    210gegggg0gegggg0geg2giggii2gkgggg2ggg1geggeg2geggeg20000gegggggggggggeg02ieg02ggg1iegiggg\
    eggeg20geg02geggeg0gegiegoeg2002mgg0geg11geggeggegggg20geg0geg0gegieg20gegmegoeg201keg2ieg\
    0ggggegoeg01020ggggeg1kggieggegiegoeg00000geg0geg22212gkg1giggigggg211ggggiggeg11gggggggeg\
    211ggggeggeg11ggggeggeggeg2220211gggggggeg11gggggggeg11gegggggeg211gggggggeg11gggggggeg021\
    1ggggeggeg11ggggeg1geggeg211ggggeggeg1giggeg2201giggeggiggeggeg22011geggeg1geggeg1ggggeg02\
    1ggggeggigggg1geggegggg2oeg2oeg2oeggeg022021ieg12geggeg02geg22ikg1gegggg20geggig1ggggeg2ge\
    g2ggggig22200gmg1geg1gggggg1geggmg00gmg21geggog1geggmg1geggkg1ggg2gig1geggeg200geg11gegggg\
    geg1gggggg00geg21gkggeg1gkggeg1giggeg222gggggg22ggg1gegggg1geggig21gegggg1geggeg022200geg1\
    gkggeg1ggggeg00geg1ggggeggiggggggg1geggeg2ggggeg022222gegggggggggggggggg02222ggggggggggggg\
    gg02222ggggeggegggggeg2kgg0geg2geggeg\
    ";

pub(super) const STANDARD_VISCOELASTIC: &str = "\
    01012kekkek2kekkek2kek0kekkek012kekkek21kekkekkek21kekkekkek0210kekkek0kekkek10kek2kekkekk\
    ek220kekkek0kekkek0kekkek\
    ";

pub(super) const WIDE_VISCOELASTIC: &str = "\
    0001202geggeg2geggeg20keggeg00002meg000000oeogeggeggeggeggeggeggeggeg2geggeggeg2002000iggg\
    egggg1geg1geggeggeggeigei002geg000qemgeggeggeggeggeg22gigggg2ggggeg22geggegggo2202geggeg22\
    0geg22mekgeggeggeg0geggeggeg2ieg2keg0geg0gek2ieg0gek2ieg0gekiei\
    ";
