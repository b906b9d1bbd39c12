package sunbeam.app.commands.export;

import org.apache.commons.math3.special.BesselJ;

/** Gratings along x whose orders have a power in closed form (Goodman, Introduction to Fourier Optics, section 4.4). */
enum ClosedForm {
    /** J_m(k w A)^2, the amplitude A half of the height. */
    SINUSOID(200e-9, """
            // J_m(phase / 2)^2, by Bessel's integral over one period, which equal steps do exactly for orders far below their number.
            float efficiency(int m, float phase) {
                const int STEPS = 64;
                float sum = 0.0;
                for (int i = 0; i < STEPS; i++) {
                    float t = 2.0 * PI * float(i) / float(STEPS);
                    sum += cos(float(m) * t - 0.5 * phase * sin(t));
                }
                return sum * sum / float(STEPS * STEPS);
            }
            """) {
        @Override
        double efficiency(int order, double phase) {
            return Math.pow(BesselJ.value(Math.abs(order), 0.5 * phase), 2);
        }
    },
    /** sinc^2(k w H / 2 pi - m). */
    BLAZE(250e-9, """
            // sinc^2(phase / 2 pi - m)
            float efficiency(int m, float phase) {
                float a = 0.5 * phase - PI * float(m);
                float sinc = abs(a) < 1e-3 ? 1.0 : sin(a) / a;
                return sinc * sinc;
            }
            """) {
        @Override
        double efficiency(int order, double phase) {
            double a = 0.5 * phase - Math.PI * order;
            return Math.abs(a) < 1e-6 ? 1 : Math.pow(Math.sin(a) / a, 2);
        }
    },
    /** Ridges of half the period. */
    LAMELLAR(137.5e-9, """
            // Ridges that take a share of the period: 1 - 4 r (1 - r) sin^2(phase / 2), or the rest's share of order m.
            float efficiency(int m, float phase) {
                float dark = pow(sin(0.5 * phase), 2.0);
                float a = PI * float(m);
                return m == 0 ? 1.0 - 4.0 * ridge * (1.0 - ridge) * dark : 4.0 * dark * pow(sin(a * ridge) / a, 2.0);
            }
            """) {
        @Override
        double efficiency(int order, double phase) {
            double dark = Math.pow(Math.sin(0.5 * phase), 2);
            double a = Math.PI * order;
            return order == 0 ? 1 - dark : 4 * dark * Math.pow(Math.sin(0.5 * a) / a, 2);
        }
    };

    private final double heightMetres;
    private final String shader;

    ClosedForm(double heightMetres, String shader) {
        this.heightMetres = heightMetres;
        this.shader = shader;
    }

    /** From the lowest to the highest place, metres. */
    double heightMetres() {
        return heightMetres;
    }

    String shader() {
        return shader;
    }

    /**
     * Power of an order, of a flat mirror's.
     *
     * @param phase by which the height delays light, k |w| h
     */
    abstract double efficiency(int order, double phase);
}
