package sunbeam.app.measure.performance;

import sunbeam.precompute.colourtable.ColourSource;
import sunbeam.precompute.colourtable.ColourSources;
import sunbeam.precompute.shader.ShaderTables;

/**
 * Where the time goes in which a table of colours is made, seconds.
 *
 * @param spectra Fourier transforms and resampling, which the evaluating shader reads
 * @param graphics a context, the upload, and the compilation
 * @param evaluation of all places by the shader
 * @param rest places, square roots, and the spline's coefficients
 * @param places that were evaluated, those included that a table was tried at
 */
record BakeTimes(double spectra, double graphics, double evaluation, double rest, long places) {

    /** A source of colours that takes the time; of a table that is made again, all together. */
    static final class Clock implements ColourSources {
        private final ColourSources sources;
        private final long start = System.nanoTime();
        private long spectra;
        private long graphics;
        private long evaluation;
        private long places;
        private boolean used;

        Clock(ColourSources sources) {
            this.sources = sources;
        }

        @Override
        public ColourSource of(ShaderTables tables, long asked) {
            long before = System.nanoTime();
            if (!used) {
                spectra = before - start;
            }
            used = true;
            ColourSource source = sources.of(tables, asked);
            graphics += System.nanoTime() - before;
            return new ColourSource() {
                @Override
                public float[] xyz(float[] uvw) {
                    long begun = System.nanoTime();
                    float[] xyz = source.xyz(uvw);
                    evaluation += System.nanoTime() - begun;
                    places += uvw.length / 3;
                    return xyz;
                }

                @Override
                public void close() {
                    source.close();
                }
            };
        }

        /** What it took, all being done now. */
        BakeTimes times() {
            long all = System.nanoTime() - start;
            return new BakeTimes(
                    1e-9 * spectra,
                    1e-9 * graphics,
                    1e-9 * evaluation,
                    1e-9 * (all - spectra - graphics - evaluation),
                    places);
        }

        /** Whether anybody asked for colours. */
        boolean used() {
            return used;
        }
    }
}
