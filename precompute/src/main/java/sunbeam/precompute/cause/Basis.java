package sunbeam.precompute.cause;

import java.util.function.Supplier;
import org.apache.commons.math3.complex.Complex;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.plan.GridSampling;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.resample.PowerFields;
import sunbeam.precompute.table.FourierTable;

/** The functions of the height, and of the phase, that a plan works with; made once, when they are first asked for. */
final class Basis {
    private final Plan plan;
    private final Supplier<FourierTable> table;
    private PowerFields fields;
    private double[][][] terms;

    Basis(Plan plan, Supplier<FourierTable> table) {
        this.plan = plan;
        this.table = table;
    }

    /** Powers of the bins of a grid. */
    synchronized PowerFields fields() {
        if (fields == null) {
            GridSampling grid = (GridSampling) plan.sampling();
            fields =
                    new PowerFields(table.get(), plan.expansion(), grid.budget().powerBasis());
        }
        return fields;
    }

    /** sum_n (-i)^turns c_n T_n at every height: real parts, imaginary parts. */
    double[][] sums(HeightLevels heights, double[] coefficients) {
        double[][][] all = terms(heights);
        double[][] sums = new double[2][heights.count()];
        for (int n = 0; n < coefficients.length; n++) {
            for (int part = 0; part < 2; part++) {
                for (int i = 0; i < sums[part].length; i++) {
                    sums[part][i] += coefficients[n] * all[n][part][i];
                }
            }
        }
        return sums;
    }

    private synchronized double[][][] terms(HeightLevels heights) {
        if (terms == null) {
            Expansion expansion = plan.expansion();
            double[] levels = heights.levels();
            terms = new double[expansion.terms()][2][heights.count()];
            for (int n = 0; n < terms.length; n++) {
                Complex turn = expansion.kind().turn(n);
                for (int i = 0; i < levels.length; i++) {
                    Complex value = expansion
                            .basis(n, expansion.scale().scaled(levels[i]))
                            .multiply(turn);
                    terms[n][0][i] = value.getReal();
                    terms[n][1][i] = value.getImaginary();
                }
            }
        }
        return terms;
    }
}
