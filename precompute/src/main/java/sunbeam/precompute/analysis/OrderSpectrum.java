package sunbeam.precompute.analysis;

import java.util.function.Consumer;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.spectrum.Band;
import sunbeam.precompute.spectrum.CoefficientTable;
import sunbeam.precompute.spectrum.Expansion;
import sunbeam.precompute.spectrum.FourierTable;
import sunbeam.precompute.spectrum.HeightScale;
import sunbeam.precompute.spectrum.LowRankExpansion;
import sunbeam.precompute.spectrum.PhaseNodes.GaussLegendre;

/**
 * Light that the scalar model sends into the orders of a surface that repeats without end, one for each DFT bin F_j: the share (1 +
 * wi.wr)^2 / (w^2 cos theta_i cos theta_r) |F_j(k w)|^2 of a mirror's light, where the window's Gaussian drops out (docs/theory.md). Times
 * R(theta_d) it is the efficiency; a flat mirror's zero order has R. Immutable.
 */
public final class OrderSpectrum {
    // Root mean square error of exp(i k w h); float32 rounds to a tenth of it.
    private static final double TOLERANCE = 1e-6;
    private static final double LARGEST_W = 2;
    // Least cosine of an order; one exactly on the horizon has a rounding error of about 1e-8.
    static final double GRAZING = 1e-6;
    // Square of the cosine in widths of the order's Gaussian, below which 1 / cosine varies over it by more than 1e-3.
    private static final double NEAR_HORIZON = 27;
    // Largest such square; windows of 5 um or more then err by at most 2 %.
    private static final double FARTHEST = 0.5;
    // Half width of the integral over exp(-x^2): 5e-7 of it lie beyond.
    private static final double REACH = 3.5;
    private static final GaussLegendre NODES = GaussLegendre.of(16);

    private final double width;
    private final double height;
    // Bins that are no aliases of others: a sampled surface repeats its spectrum.
    private final int columns;
    private final int rows;
    private final Band bandX;
    private final Band bandY;
    private final HeightScale scale;
    private final CoefficientTable coefficients;
    // [(bin * terms + term) * 2]: real and imaginary parts
    private final float[] values;

    /** Order above the horizon: bins x and y, and an amplitude whose square is the share of a mirror's light. */
    record Wave(int x, int y, DirectionPair pair, double real, double imaginary) {
        double power() {
            return real * real + imaginary * imaginary;
        }

        Wave times(double factor) {
            return new Wave(x, y, pair, factor * real, factor * imaginary);
        }
    }

    /** Bin with its direction's x, y and z^2, which is negative beyond the horizon. */
    private record Bin(int x, int y, double outX, double outY, double square) {}

    public OrderSpectrum(HeightMap map) {
        width = map.width();
        height = map.height();
        columns = map.columns();
        rows = map.rows();
        bandX = distinct(columns, width);
        bandY = distinct(rows, height);
        scale = HeightScale.midRange(map);
        Expansion expansion = LowRankExpansion.of(
                map, scale, 0, scale.phase(CieTable.MINIMUM_WAVELENGTH, LARGEST_W), TOLERANCE, Integer.MAX_VALUE);
        coefficients = CoefficientTable.sampled(expansion);
        values = values(FourierTable.of(map, expansion, bandX, bandY, terms -> {}));
    }

    /** Returns the bins that are visible under some light at the shortest wavelength. */
    private static Band visibleBins(double length) {
        int most = (int) Math.ceil(LARGEST_W * length / CieTable.MINIMUM_WAVELENGTH);
        return Band.of(-most, most);
    }

    private static Band distinct(int samples, double length) {
        Band visible = visibleBins(length);
        return visible.count() < samples ? visible : new Band(-(samples / 2), samples);
    }

    /** Returns the number of orders visible under some light, those beyond half of the sampling frequency included. */
    public static long orders(HeightMap map) {
        return (long) visibleBins(map.width()).count()
                * visibleBins(map.height()).count();
    }

    /** Returns the number of orders with an amplitude of their own, which memory holds. */
    public static long amplitudes(HeightMap map) {
        return (long) distinct(map.columns(), map.width()).count()
                * distinct(map.rows(), map.height()).count();
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
     * Visits the orders above the horizon.
     *
     * @param wi direction to the light, in the patch's frame
     * @param wavelength meters, within 380..780 nm
     * @param sampled true for a scan, whose light fills each bin
     */
    void forEach(Direction wi, double wavelength, boolean sampled, Consumer<Wave> visitor) {
        forEachBin(wi, wavelength, 1, bin -> {
            double cosine = Math.sqrt(bin.square);
            double stretch = 1;
            double share = 1;
            double radius = Math.hypot(bin.outX, bin.outY);
            if (sampled && radius > 0) {
                // The mean of 1 / cosine over the bin: dr / cos alpha = d alpha.
                double half = 0.5 * wavelength * radius / Math.hypot(bin.outX * width, bin.outY * height);
                double low = Math.asin(Math.max(-1, Math.min(1, radius - half)));
                double high = Math.asin(Math.min(1, radius + half));
                cosine = Math.cos(0.5 * (low + high));
                stretch = Math.sin(0.5 * (low + high)) / radius;
                share = Math.sqrt(cosine * (high - low) / (2 * half));
            }
            if (cosine > GRAZING) {
                Direction out = new Direction(bin.outX * stretch, bin.outY * stretch, cosine);
                visitor.accept(wave(bin, wavelength, new DirectionPair(wi, out)).times(share));
            }
        });
    }

    /** Visits the bins that lie, in part at least, in a square around the disc of directions of a radius, 1 up to the horizon. */
    private void forEachBin(Direction wi, double wavelength, double radius, Consumer<Bin> visitor) {
        Band alongX = reached(wi.x(), radius, width / wavelength);
        Band alongY = reached(wi.y(), radius, height / wavelength);
        for (int y = alongY.first(); y <= alongY.last(); y++) {
            double outY = -wi.y() - wavelength * y / height;
            for (int x = alongX.first(); x <= alongX.last(); x++) {
                double outX = -wi.x() - wavelength * x / width;
                visitor.accept(new Bin(x, y, outX, outY, 1 - outX * outX - outY * outY));
            }
        }
    }

    private static Band reached(double light, double radius, double wavelengths) {
        return Band.covering(-radius - light, radius - light, wavelengths, 0);
    }

    private Wave wave(Bin bin, double wavelength, DirectionPair pair) {
        double[] factors = coefficients.at(scale.phase(wavelength, -pair.w()));
        int column = Math.floorMod(bin.x - bandX.first(), columns);
        int row = Math.floorMod(bin.y - bandY.first(), rows);
        int at = 2 * factors.length * (row * bandX.count() + column);
        double real = 0;
        double imaginary = 0;
        for (double factor : factors) {
            real += factor * values[at++];
            imaginary += factor * values[at++];
        }
        double geometry = Math.sqrt(Gain.orderShare(pair));
        return new Wave(bin.x, bin.y, pair, geometry * real, geometry * imaginary);
    }

    private double power(double normal, Bin bin, double wavelength, DirectionPair pair) {
        double overMirror =
                RefractiveIndex.schlick(normal, pair.cosThetaD()) / RefractiveIndex.schlick(normal, pair.cosThetaI());
        return overMirror * wave(bin, wavelength, pair).power();
    }

    /**
     * Returns the light of all orders over that of a mirror; close to the horizon, of the Gaussian above it.
     *
     * @param wi direction to the light, in the patch's frame
     * @param wavelength meters, within 380..780 nm
     * @param sigmaFrequency of the window's amplitude spectrum, cycles per meter; 0 for an infinite window
     */
    public double sum(RefractiveIndex index, Direction wi, double wavelength, double sigmaFrequency) {
        double normal = index.reflectance(wavelength);
        double blur = wavelength * sigmaFrequency;
        double[] sum = new double[1];
        forEachBin(wi, wavelength, 1 + 1.5 * REACH * blur, bin -> {
            if (bin.square > Math.max(GRAZING * GRAZING, Math.min(FARTHEST, NEAR_HORIZON * blur))) {
                Direction out = new Direction(bin.outX, bin.outY, Math.sqrt(bin.square));
                sum[0] += power(normal, bin, wavelength, new DirectionPair(wi, out));
            } else if (blur > 0 && bin.square > -3 * REACH * blur) {
                sum[0] += atHorizon(normal, bin, wavelength, wi, blur);
            }
        });
        return sum[0];
    }

    /** Integrates over the radius r = sin alpha; dr / cos alpha = d alpha takes the pole at the horizon. */
    private double atHorizon(double normal, Bin bin, double wavelength, Direction wi, double blur) {
        double radius = Math.hypot(bin.outX, bin.outY);
        double low = Math.asin(Math.max(0, Math.min(1, radius - REACH * blur)));
        double high = Math.asin(Math.min(1, radius + REACH * blur));
        double sum = 0;
        for (int i = 0; i < NODES.nodes().length; i++) {
            double alpha = low + 0.5 * (1 + NODES.nodes()[i]) * (high - low);
            double sine = Math.sin(alpha);
            Direction out = new Direction(bin.outX * sine / radius, bin.outY * sine / radius, Math.cos(alpha));
            double off = (sine - radius) / blur;
            double weight = 0.5 * NODES.weights()[i] * (high - low) * CoherenceWindow.power(off) * Math.cos(alpha);
            sum += weight * power(normal, bin, wavelength, new DirectionPair(wi, out));
        }
        return sum / (Math.sqrt(Math.PI) * blur);
    }

    SpatialFrequency frequency(int x, int y) {
        return new SpatialFrequency(x / width, y / height);
    }

    /** Returns a frequency's place among the bins, along x and y. */
    double[] bin(SpatialFrequency frequency) {
        return new double[] {frequency.x() * width, frequency.y() * height};
    }
}
