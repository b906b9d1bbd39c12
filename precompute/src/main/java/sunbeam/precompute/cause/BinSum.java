package sunbeam.precompute.cause;

import java.util.Arrays;
import org.apache.commons.math3.complex.Complex;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.reference.ReferenceEvaluator;
import sunbeam.precompute.resample.PowerFields;

/** Bins around a frequency, times what they lend to it. */
record BinSum(ReferenceEvaluator evaluator, AxisResponse alongX, AxisResponse alongY, double fx, double fy) {

    BinSum withExactWindow() {
        return new BinSum(evaluator, alongX.exact(), alongY.exact(), fx, fy);
    }

    /**
     * Power of the bins.
     *
     * @param ensemble whether squares are summed; else |sum|^2
     * @return of all bins, and of those that the plan's table holds
     */
    double[] powers(double[][] values, boolean ensemble, Plan plan) {
        int[] binsX = alongX.bins(fx);
        int[] binsY = alongY.bins(fy);
        Complex[][] bins = evaluator.bins(values[0], values[1], binsX, binsY);
        double[] weightsX = new double[binsX.length];
        Arrays.setAll(weightsX, x -> alongX.at(fx, binsX[x]));
        double[] all = new double[3];
        double[] stored = new double[3];
        for (int y = 0; y < binsY.length; y++) {
            double weightY = alongY.at(fy, binsY[y]);
            for (int x = 0; x < binsX.length; x++) {
                double weight = weightY * weightsX[x];
                add(all, weight, bins[y][x]);
                if (PlanModel.contains(plan.bandX(), binsX[x]) && PlanModel.contains(plan.bandY(), binsY[y])) {
                    add(stored, weight, bins[y][x]);
                }
            }
        }
        return ensemble
                ? new double[] {all[2], stored[2]}
                : new double[] {all[0] * all[0] + all[1] * all[1], stored[0] * stored[0] + stored[1] * stored[1]};
    }

    private static void add(double[] sums, double weight, Complex bin) {
        sums[0] += weight * bin.getReal();
        sums[1] += weight * bin.getImaginary();
        sums[2] += weight * PlanModel.squared(bin);
    }

    /** The same of powers in a basis of their own, which knows the plan's bins only. */
    double ofBasis(PowerFields fields, double zeta, Plan plan) {
        int[] binsX = alongX.bins(fx);
        int[] binsY = alongY.bins(fy);
        double[] weightsX = weights(alongX, fx, binsX, plan.bandX());
        double[] weightsY = weights(alongY, fy, binsY, plan.bandY());
        double[] functions = fields.functions(zeta);
        double sum = 0;
        for (int y = 0; y < binsY.length; y++) {
            for (int x = 0; x < binsX.length; x++) {
                double weight = weightsY[y] * weightsX[x];
                if (weight != 0) {
                    int bin = (binsY[y] - plan.bandY().first()) * plan.bandX().count()
                            + binsX[x]
                            - plan.bandX().first();
                    sum += weight * fields.power(functions, bin);
                }
            }
        }
        return sum;
    }

    private static double[] weights(AxisResponse response, double frequency, int[] bins, Band band) {
        double[] weights = new double[bins.length];
        for (int i = 0; i < bins.length; i++) {
            weights[i] = PlanModel.contains(band, bins[i]) ? response.at(frequency, bins[i]) : 0;
        }
        return weights;
    }
}
