package sunbeam.precompute.analysis;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.expansion.HeightScale;
import sunbeam.precompute.expansion.LowRankExpansion;
import sunbeam.precompute.expansion.PhaseSamples;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.table.FourierTable;
import sunbeam.precompute.table.PatchIdentity;
import sunbeam.precompute.table.TableBuilder;

/**
 * Light that the scalar model sends into the diffraction orders of a surface that repeats one patch without end, one order for each DFT bin
 * F_j. Order j has the share (1 + wi.wr)^2 / (w^2 cos theta_i cos theta_r) |F_j(k w)|^2 of a mirror's light: the integral of brdf cos
 * theta_r over the order's solid angle, lambda^2 df / cos theta_r, where the Gaussian of the window, of area 1 / (4 pi sigma_s^2), drops
 * out (docs/theory.md). Times R(theta_d) it is the order's efficiency; a flat mirror's zero order has R. Immutable.
 */
public final class OrderSpectrum {
    // Root mean square error of the expansion of exp(i k w h); float32 rounds amplitudes to a tenth of it.
    private static final double TOLERANCE = 1e-6;
    private static final double LARGEST_W = 2;

    private final double width;
    private final double height;
    private final Band bandX;
    private final Band bandY;
    private final HeightScale scale;
    private final PhaseSamples coefficients;
    // [(bin * terms + term) * 2]: real and imaginary parts
    private final float[] values;

    /** Receives the orders that lie above the horizon. */
    @FunctionalInterface
    public interface Visitor {
        /**
         * Receives an order.
         *
         * @param x bin along x; its frequency is x / width
         * @param y bin along y; its frequency is y / height
         * @param pair light and direction of the order
         * @param real real part of an amplitude whose square is the order's share of a mirror's light
         * @param imaginary imaginary part of this amplitude
         */
        void visit(int x, int y, DirectionPair pair, double real, double imaginary);
    }

    /** Transforms one period of a surface, without missing samples. */
    public OrderSpectrum(HeightMap map) {
        width = map.width();
        height = map.height();
        bandX = visibleBins(map.columns(), width);
        bandY = visibleBins(map.rows(), height);
        HeightLevels levels = HeightLevels.of(map);
        scale = HeightScale.midRange(levels);
        Expansion expansion = LowRankExpansion.within(
                levels, scale, 0, scale.phase(CieTable.MINIMUM_WAVELENGTH, LARGEST_W), TOLERANCE);
        coefficients = PhaseSamples.of(expansion::coefficients, 0, expansion.maximumPhase());
        PatchIdentity identity = new PatchIdentity("orders", map.columns(), map.rows(), map.pitchX(), map.pitchY(), "");
        values = values(new TableBuilder(identity, levels, terms -> {}).build(expansion, bandX, bandY));
    }

    /** Returns the bins that are visible at the shortest wavelength under some light and are no aliases of others. */
    private static Band visibleBins(int samples, double length) {
        int visible = (int) Math.ceil(LARGEST_W * length / CieTable.MINIMUM_WAVELENGTH);
        int most = Math.min((samples - 1) / 2, visible);
        return Band.of(-most, most);
    }

    /** Returns the number of orders of a map that some light shows. */
    public static long orders(HeightMap map) {
        return (long) visibleBins(map.columns(), map.width()).count()
                * visibleBins(map.rows(), map.height()).count();
    }

    private static float[] values(FourierTable table) {
        int bins = table.real()[0].length;
        float[] values = new float[Math.multiplyExact(2 * table.terms(), bins)];
        for (int bin = 0, at = 0; bin < bins; bin++) {
            for (int n = 0; n < table.terms(); n++) {
                values[at++] = table.real()[n][bin];
                values[at++] = table.imaginary()[n][bin];
            }
        }
        return values;
    }

    /**
     * Visits the orders above the horizon, row by row.
     *
     * @param wi direction to the light, in the patch's frame
     * @param wavelength wavelength in meters, within 380..780 nm
     */
    public void forEach(Direction wi, double wavelength, Visitor visitor) {
        for (int y = bandY.first(); y <= bandY.last(); y++) {
            double outY = -wi.y() - wavelength * y / height;
            for (int x = bandX.first(); x <= bandX.last(); x++) {
                double outX = -wi.x() - wavelength * x / width;
                double square = 1 - outX * outX - outY * outY;
                if (square > 0) {
                    visit(
                            x,
                            y,
                            new DirectionPair(wi, new Direction(outX, outY, Math.sqrt(square))),
                            wavelength,
                            visitor);
                }
            }
        }
    }

    private void visit(int x, int y, DirectionPair pair, double wavelength, Visitor visitor) {
        double[] factors = coefficients.at(scale.phase(wavelength, -pair.w()));
        int at = 2 * factors.length * ((y - bandY.first()) * bandX.count() + x - bandX.first());
        double real = 0;
        double imaginary = 0;
        for (double factor : factors) {
            real += factor * values[at++];
            imaginary += factor * values[at++];
        }
        double geometry = (1 + pair.wi().dot(pair.wr())) / (-pair.w() * Math.sqrt(pair.cosThetaI() * pair.cosThetaR()));
        visitor.visit(x, y, pair, geometry * real, geometry * imaginary);
    }

    /** Returns the light of all orders, relative to the light of a mirror: 1 if the model conserves energy. */
    public double total(Direction wi, double wavelength) {
        double[] sum = new double[1];
        forEach(wi, wavelength, (x, y, pair, real, imaginary) -> sum[0] += real * real + imaginary * imaginary);
        return sum[0];
    }

    SpatialFrequency frequency(int x, int y) {
        return new SpatialFrequency(x / width, y / height);
    }
}
