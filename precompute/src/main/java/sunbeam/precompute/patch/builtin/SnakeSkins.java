package sunbeam.precompute.patch.builtin;

/** The two snake skins; docs/guide.md has the measurements beside these numbers. */
final class SnakeSkins {
    private static final double SIDE = 65e-6;
    /** A power of two for the Fourier transforms; 63.5 nm apart, finer than the 95 nm that 380 nm light needs. */
    private static final int SAMPLES = 1024;

    private SnakeSkins() {}

    /** Elaphe guttata: long pointed fingers in columns that run on over many rows, so colors lie along x only. */
    static FingerSkin elapheLike() {
        RowLayout layout = new RowLayout(
                21, // rows: 3.1 um apart
                63, // fingers: 1.03 um apart
                0.09, // row spread
                0.16, // finger spread
                4, // rows over which columns continue
                0, // count spread: none, columns continue
                0.6e-6, // wander
                9, // wander modes along x
                6, // wander modes along y
                0.4e-6, // tip spread
                7e-9, // height spread
                0); // lean
        FingerShape shape = new FingerShape(
                0.97, // length
                2.4, // tip exponent
                2.6, // base exponent
                38e-9, // crest
                0, // fall
                6e-9, // bulge
                48e-9, // dome
                0.25, // fade
                -31e-9, // floor
                5e-9, // floor fall
                55e-9, // notch depth
                220e-9, // notch length
                35e-9); // edge width
        return new FingerSkin(SIDE, SAMPLES, layout, shape, new Ground(34e-9, 3.6, 24, 6e-9, 60e-9), 1);
    }

    /** Xenopeltis unicolor: blunt short fingers in independent, meandering rows, so colors spread about y. */
    static FingerSkin xenopeltisLike() {
        RowLayout layout = new RowLayout(
                42, // rows: 1.55 um apart
                118, // fingers: 0.55 um apart
                0.02, // row spread
                0.15, // finger spread
                0, // rows are independent
                2, // count spread
                0.9e-6, // wander
                14, // wander modes along x
                4, // wander modes along y
                0.1e-6, // tip spread
                11e-9, // height spread
                0.07); // lean: 4 degrees
        FingerShape shape = new FingerShape(
                0.72, // length
                3.2, // tip exponent
                1.7, // base exponent
                78e-9, // crest
                125e-9, // fall
                0, // bulge
                30e-9, // dome
                0.2, // fade
                -42e-9, // floor
                0, // floor fall
                70e-9, // notch depth
                200e-9, // notch length
                35e-9); // edge width
        return new FingerSkin(SIDE, SAMPLES, layout, shape, new Ground(34e-9, 3.2, 24, 7e-9, 60e-9), 2);
    }
}
