package sunbeam.app.promise;

import static org.assertj.core.api.Assertions.assertThat;

import org.joml.Vector2d;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.color.CieTable;

/**
 * The look-up of D. Dhillon, J. Teyssier, M. Single, I. Gaponenko, M. Milinkovitch and M. Zwicker, "Interactive Diffraction
 * from Biological Nanostructures", Computer Graphics Forum 33 (2014): with exp(i k w h) = sum_n (i k w h)^n / n!, the color of
 * coherent power is a polynomial in w, whose 2 N + 1 coefficients lie in tables over (u, v).
 *
 * <pre>C(u, w) = sum_r w^r int sum_{n + m = r} Re(T_n conj(T_m)) xyz dlambda,  T_n = (i k)^n / n! int g h^n e^(i k u x) dx</pre>
 *
 * <p>Here of a sinusoidal grating under a Gaussian window g, by direct sums. Heights are centered and w is counted in units of
 * 2, which keeps the terms as small as they can be.
 */
final class TaylorSeriesTest {
    private static final double PERIOD = 2.5e-6;
    private static final double SIGMA = 2.5e-6;
    private static final double STEP = 0.05e-6;
    private static final int TERMS = 60;
    private static final CieTable CIE = CieTable.load();

    /** T_n at a wavelength; a count of one means the whole of exp(i k w h) at w = 2 share instead. */
    private static Vector2d[] terms(double relief, double wavelength, double u, int count, double share) {
        Vector2d[] terms = new Vector2d[count];
        double k = 2 * Math.PI / wavelength;
        for (int n = 0; n < count; n++) {
            terms[n] = new Vector2d();
        }
        for (double x = -5 * SIGMA; x < 5 * SIGMA; x += STEP) {
            double phase = 2 * k * 0.5 * relief * Math.cos(2 * Math.PI * x / PERIOD);
            double term = Math.exp(-0.5 * x * x / (SIGMA * SIGMA));
            for (int n = 0; n < count; n++) {
                double angle = k * u * x + (count == 1 ? share * phase : 0.5 * Math.PI * n);
                terms[n].add(term * Math.cos(angle), term * Math.sin(angle));
                term *= phase / (n + 1);
            }
        }
        return terms;
    }

    /** Relative errors at directions near the first order: of the series in double precision, and in float32. */
    private static double[] errors(double relief) {
        double[] worst = new double[2];
        for (double u = 0.2; u < 0.25; u += 0.01) {
            // Light along the normal.
            double half = 0.5 * (1 + Math.sqrt(1 - u * u));
            double[] exact = new double[3];
            double[][] coefficients = new double[2 * TERMS - 1][3];
            for (double wavelength = 380e-9; wavelength <= 780e-9; wavelength += 5e-9) {
                Vector2d[] terms = terms(relief, wavelength, u, TERMS, 0);
                double power = terms(relief, wavelength, u, 1, half)[0].lengthSquared();
                for (int c = 0; c < 3; c++) {
                    double weight = CIE.at(wavelength, c);
                    exact[c] += weight * power;
                    for (int r = 0; r < coefficients.length; r++) {
                        for (int n = Math.max(0, r - TERMS + 1); n <= Math.min(r, TERMS - 1); n++) {
                            coefficients[r][c] += weight * terms[n].dot(terms[r - n]);
                        }
                    }
                }
            }
            for (int c = 0; c < 3; c++) {
                double inDouble = 0;
                float inFloat = 0;
                for (int r = coefficients.length - 1; r >= 0; r--) {
                    inDouble = inDouble * half + coefficients[r][c];
                    inFloat = inFloat * (float) half + (float) coefficients[r][c];
                }
                worst[0] = Math.max(worst[0], Math.abs(inDouble / exact[c] - 1));
                worst[1] = Math.max(worst[1], Math.abs(inFloat / exact[c] - 1));
            }
        }
        return worst;
    }

    @Test
    void aShallowReliefComesOutAsTheDirectSumHasIt() {
        double[] errors = errors(0.1e-6);
        assertThat(errors[0]).isLessThan(1e-12);
        // Terms of up to e^3.3 cancel: some digits of float32's seven are lost.
        assertThat(errors[1]).isLessThan(1e-4);
    }

    @Test
    void aDeepReliefLeavesFloat32NoDigits() {
        double[] errors = errors(0.8e-6);
        // 2 k relief is up to 26: terms of e^26 = 2e11, of which float32 keeps 1e4.
        assertThat(errors[1]).isGreaterThan(1);
        assertThat(errors[0]).isLessThan(1e-2);
    }
}
