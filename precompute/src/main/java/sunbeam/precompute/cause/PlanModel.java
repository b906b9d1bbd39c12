package sunbeam.precompute.cause;

import java.util.EnumMap;
import java.util.Map;
import java.util.function.Supplier;
import org.apache.commons.math3.complex.Complex;
import sunbeam.precompute.cause.AxisResponse.Exact;
import sunbeam.precompute.cause.AxisResponse.Form;
import sunbeam.precompute.cause.AxisResponse.Interpolated;
import sunbeam.precompute.cause.AxisResponse.Nearest;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.BinSampling;
import sunbeam.precompute.plan.GridSampling;
import sunbeam.precompute.plan.Neighbourhood;
import sunbeam.precompute.plan.OrderSampling;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.RaySampling;
import sunbeam.precompute.plan.Sampling;
import sunbeam.precompute.reference.ReferenceEvaluator;
import sunbeam.precompute.resample.PowerFields;
import sunbeam.precompute.table.FourierTable;

/**
 * What a plan's shader yields, in double precision, with more and more of its approximations. Direct sums over the surface:
 * for a few directions. Safe for use by several threads.
 */
public final class PlanModel {
    private static final PlanNode.Place ANYWHERE = new PlanNode.Anywhere();

    private final Plan plan;
    private final HeightMap map;
    private final ReferenceEvaluator evaluator;
    private final PlanNodes nodes;
    private final Basis basis;
    private final Form colourForm;
    private final Form spectralForm;

    /**
     * A plan over its patch.
     *
     * @param table of the plan; asked for where the ensemble's powers have a basis of their own
     */
    public PlanModel(Plan plan, HeightMap map, CieTable cie, Supplier<FourierTable> table) {
        this.plan = plan;
        this.map = map;
        this.evaluator = new ReferenceEvaluator(map, plan.window(), plan.origin());
        this.nodes = new PlanNodes(cie);
        this.colourForm = form(plan.sampling());
        Sampling single = plan.sampling() instanceof GridSampling grid ? grid.single() : plan.sampling();
        this.spectralForm = form(single);
        this.basis = new Basis(plan, table);
    }

    private static Form form(Sampling sampling) {
        if (sampling instanceof BinSampling bins) {
            return Nearest.of(bins.neighbourhood());
        }
        if (sampling instanceof RaySampling rays) {
            return Nearest.of(rays.neighbourhood());
        }
        return sampling instanceof OrderSampling
                ? Nearest.of(new Neighbourhood(0, Neighbourhood.Anchor.NEAREST))
                : Interpolated.of(((GridSampling) sampling).interpolation());
    }

    double sigmaFrequency() {
        return plan.window().sigmaFrequency();
    }

    HeightMap map() {
        return map;
    }

    /** Powers of the plan's average at one wavelength in metres, after each approximation but float32. */
    public Map<ErrorSource, Double> powers(DirectionPair pair, double wavelength) {
        return powers(pair, wavelength, ANYWHERE, spectralForm);
    }

    /** X, Y, Z of the power of the plan's average, after each approximation but float32. */
    public Map<ErrorSource, double[]> xyz(DirectionPair pair) {
        Map<ErrorSource, double[]> result = new EnumMap<>(ErrorSource.class);
        // A direction may have no wavelength at all.
        stages(0, 0, 0, 0).keySet().forEach(source -> result.put(source, new double[3]));
        for (PlanNode node : nodes.of(plan.sampling(), this, pair)) {
            powers(pair, node.wavelength(), node.place(), colourForm).forEach((source, power) -> {
                double[] xyz = result.get(source);
                for (int c = 0; c < 3; c++) {
                    xyz[c] += node.weights()[c] * power;
                }
            });
        }
        return result;
    }

    /** With exact sums at the plan's wavelengths, and after each further approximation. */
    private static Map<ErrorSource, Double> stages(double exact, double expanded, double windowed, double cropped) {
        Map<ErrorSource, Double> stages = new EnumMap<>(ErrorSource.class);
        stages.put(ErrorSource.WAVELENGTHS, exact);
        stages.put(ErrorSource.EXPANSION, expanded);
        stages.put(ErrorSource.WINDOW, windowed);
        stages.put(ErrorSource.CROP, cropped);
        return stages;
    }

    private Map<ErrorSource, Double> powers(DirectionPair pair, double wavelength, PlanNode.Place place, Form form) {
        double fx = pair.u() / wavelength;
        double fy = pair.v() / wavelength;
        boolean ensemble = plan.average() == Average.ENSEMBLE;
        double zeta = plan.expansion().scale().phase(wavelength, Math.abs(pair.w()));
        double[][] approximate = approximate(zeta);
        if (place instanceof PlanNode.OneOrder order) {
            return oneOrder(order, evaluator.phases(pair.w(), wavelength), approximate, fx, fy);
        }
        boolean exactX = place instanceof PlanNode.OnLine line && line.exactX();
        boolean exactY = place instanceof PlanNode.OnLine line && !line.exactX();
        // The square of a Gaussian is narrower by sqrt(2).
        double sigma = ensemble ? sigmaFrequency() / Math.sqrt(2) : sigmaFrequency();
        BinSum sum = new BinSum(
                evaluator,
                new AxisResponse(map.width(), sigma, exactX ? new Exact() : form),
                new AxisResponse(map.height(), sigma, exactY ? new Exact() : form.alongY()),
                fx,
                fy);
        if (ensemble && form instanceof Interpolated) {
            PowerFields fields = basis.fields();
            double interpolated = sum.ofBasis(fields, zeta, plan);
            return stages(
                    evaluator.powers(pair, wavelength).ensemble(),
                    sum.withExactWindow().ofBasis(fields, zeta, plan),
                    interpolated,
                    interpolated);
        }
        double[] bins = sum.powers(approximate, ensemble, plan);
        return ensemble
                ? stages(
                        evaluator.powers(pair, wavelength).ensemble(),
                        evaluator.powers(approximate[0], approximate[1], fx, fy).ensemble(),
                        bins[0],
                        bins[1])
                : stages(
                        evaluator.coherent(pair, wavelength),
                        squared(evaluator.windowed(approximate[0], approximate[1], fx, fy)),
                        bins[0],
                        bins[1]);
    }

    private Map<ErrorSource, Double> oneOrder(
            PlanNode.OneOrder order, double[][] exact, double[][] approximate, double fx, double fy) {
        int[] x = {order.binX()};
        int[] y = {order.binY()};
        double sigma = sigmaFrequency();
        double gauss =
                Math.exp(-(Math.pow(fx - order.binX() / map.width(), 2) + Math.pow(fy - order.binY() / map.height(), 2))
                        / (sigma * sigma));
        double of = gauss * squared(evaluator.bins(approximate[0], approximate[1], x, y)[0][0]);
        boolean stored = contains(plan.bandX(), order.binX()) && contains(plan.bandY(), order.binY());
        return stages(gauss * squared(evaluator.bins(exact[0], exact[1], x, y)[0][0]), of, of, stored ? of : 0);
    }

    static boolean contains(Band band, int bin) {
        return bin >= band.first() && bin <= band.last();
    }

    static double squared(Complex amplitude) {
        return amplitude.getReal() * amplitude.getReal() + amplitude.getImaginary() * amplitude.getImaginary();
    }

    /** The expansion's sum at every height that occurs. */
    private double[][] approximate(double zeta) {
        return basis.sums(evaluator.heights(), plan.expansion().coefficients(within(zeta)));
    }

    /** Rounding must not leave what the expansion was made for. */
    private double within(double zeta) {
        Expansion expansion = plan.expansion();
        return Math.max(expansion.minimumPhase(), Math.min(expansion.maximumPhase(), zeta));
    }
}
