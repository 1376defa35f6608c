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

pub(super) const FINE_LINEAR: &str = "\
    2101kgk1mgk00120220geggeg0geggeg20geggeggegggg0gegggg020gegggg0geggggggk21ggggggiik2igg01g\
    eggegggi01ggk2igk1geigeg01geigeiggi110100100geg2gig0geggggggm100geg0geggikggk200geggggggg0\
    mgggeg2gig0gimggg2ggggeg20000geg21ggggegggggggggggeg0000geg0geg21geggeg2ggg2giggki2ggg2ggg\
    02giggkigigggmgei0ggm0gek0geioem200000geg0gegggmggo2gggggg2ggggeg0ggi0gei0gegqeg00000geg0g\
    eg222ggggkk2gom21ggggkg1gigggg221gmkgeg21gkggeg1gkggeg221giggeggkggig222gig1geggkg21ggggig\
    21ggggig1gigggg221gigggg21gkggeg01gkggeggkg2201gig1geggeggiggkggkg22giggki2giigigggi0geg0g\
    eg0gegoeg2210000gegggggggggi0ggi0ggg0geg0gegkeg20000geggiigikgio0gim0gggqeg10qik20geg0geg0\
    gegmeg0geg0gegqeg0220mggggg0200geg2giggkigki00geggoigmgggg22000geg1ggggkggmigig000geggoggm\
    ggig0200geggoigmg00geggmigkgggg20ggg0gegoeg0ggg0gegoeg10000gik22ggg1geggig221geggig1geggkg\
    221ggggig1ggggig1giiggg22ggggik2gkkgkiggk0geg0gegqeg00200geg221gim1ggggeg21gmgggg21gmggeg1\
    gkggeg221gmggeg1gkggeg21giggeggkg221giggiggqi1giggeg00geggkigig22gkigigggg20ggg0gggogg0ggg\
    0gggogg0000geg12222gqi1giggeg1giggegggggegkgg22221gkgggg01gigggggiggkigiggig21gggggggig0gi\
    g0ggg0gggmgg01102igg2mgg02001111geggeggeggeggeg00igm2geg02ggggegggggegggg2002110121geg12ge\
    ggeggeg21geggeg21geggeg2geg1geggeggeg112geggeggeggeggeggeg1012211geggeggeggegggggeggeggeg0\
    20geg2geggeg0geggegggggegigg2ggggeg2ggg2gggggo01ieo0200geg020geggiggegggk2gig1gegggg020geg\
    0geg21gegggggeggeg2kiigeg20ggmggi2igggeg002121geggeggegggg2gggggg2giiggkggm1101000geg0geg2\
    21gggggg2gkkgkkgeg2202gig1gggggggik221gggigg1gggkgg0ikggig2kiigeg2ggi2ggggeg000geg0geg2221\
    ggiggg1ggi1geggeggeggeg22201gggggggig01ggggeggggggggek2ggigei2giigem02oiikekgek0200geg2000\
    geg022oiigeggeg2gig2gig0geggiggiggkg00geg0202kikgeggig0geg20geggiggeg2gig021geggeggeggiggi\
    ggiggeg2giggeg1012geggeqggk02ggiggk2ieg2keg2oggqeo021ggggig21geggeggeg02gkg2gkggeg02gig2ii\
    ggeg02gig2gigggq2igg02ggg2ggggeg2kgg2kgg2igggeg\
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

pub(super) const FINE_VISCOELASTIC: &str = "\
    00002112geggei2geggei012iii2geggeg2mggigi21geggegggi210keiggi0kgigeg0020012geg0keggegmeggg\
    gggg0000200mekgeggeg0000020keggeg2000geggeggeggeg002geggeggeggeggeigeggeggeggeggeigeigeige\
    iggmggm212ggiggi2gggggi021geigegggm2ggkggm212ggiggi2ggggei02ggkgem2ggiggo22220gggigikgg1gg\
    ggeg2gegigg2ggi2geggeo2202igkgeg220gei220gei20gei220gei20geggeggeggeggegiegkegkegmeggegieg\
    2keg02geggek2keg02geggek2keg02geggek2keg02geggek2keg20gegkeg0gek0gekgeg\
    ";
