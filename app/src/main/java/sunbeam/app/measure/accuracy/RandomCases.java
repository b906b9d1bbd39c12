package sunbeam.app.measure.accuracy;

import java.io.PrintWriter;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import jrtr.RenderContext;
import sunbeam.precompute.plan.PlanReport;
import sunbeam.precompute.setting.SettingException;

/** Many random cases, and how their errors are distributed by kind. */
final class RandomCases {
    private final RenderContext context;
    private final PrintWriter out;
    private final Optional<KeptCases> kept;
    // The worst of median / tolerance and 95th percentile / (3 tolerance) of each case, by what it is.
    private final Map<String, double[]> ratios = new TreeMap<>();

    /**
     * Cases on one graphics context.
     *
     * @param kept where cases that have light are written to, if anywhere
     */
    RandomCases(RenderContext context, PrintWriter out, Optional<KeptCases> kept) {
        this.kept = kept;
        this.context = context;
        this.out = out;
    }

    /**
     * Runs cases, prints a line each, and the distribution.
     *
     * @return how many missed
     */
    int run(long firstSeed, int count) {
        int missed = 0;
        int said = 0;
        int refused = 0;
        int bright = 0;
        for (long seed = firstSeed; seed < firstSeed + count; seed++) {
            RandomCase drawn = RandomCase.of(seed);
            RandomCase.Outcome outcome;
            try {
                outcome = drawn.measure(context);
            } catch (SettingException refusal) {
                refused++;
                out.printf(Locale.ROOT, "refused, %s: %s%n", drawn, refusal.getMessage());
                continue;
            }
            if (outcome.errors().count() == 0) {
                continue;
            }
            bright++;
            kept.ifPresent(folder -> folder.add(drawn));
            double ratio = outcome.errors().reached() / drawn.tolerance();
            for (String key : List.of(
                    "surface " + drawn.kind(),
                    "aim " + drawn.aim(),
                    drawn.colors() ? "XYZ" : "power",
                    drawn.area().average().toString().toLowerCase(Locale.ROOT),
                    String.format(Locale.ROOT, "tolerance %.0e", drawn.tolerance()),
                    "all")) {
                ratios.merge(key, new double[] {ratio}, RandomCases::joined);
            }
            if (ratio > 1) {
                missed++;
                said += outcome.said() ? 1 : 0;
            }
            print(drawn, outcome, ratio);
        }
        kept.ifPresent(KeptCases::close);
        out.printf(
                Locale.ROOT,
                "%d cases from seed %d, %d refused by the plan, %d with light: %d missed, %d of them as the plan had said%n",
                count,
                firstSeed,
                refused,
                bright,
                missed,
                said);
        ratios.forEach(this::print);
        return missed;
    }

    private void print(RandomCase drawn, RandomCase.Outcome outcome, double ratio) {
        String verdict = ratio <= 1 ? "kept" : outcome.said() ? "missed as said" : "missed";
        out.printf(Locale.ROOT, "%s, %.2g of what is promised: %s", verdict, ratio, drawn);
        if (ratio > 1) {
            out.printf(
                    Locale.ROOT,
                    "; %s, %d directions; %s",
                    outcome.errors(),
                    outcome.errors().count(),
                    new PlanReport(outcome.plan()).summary());
        }
        out.println();
        out.flush();
    }

    private static double[] joined(double[] a, double[] b) {
        double[] all = Arrays.copyOf(a, a.length + b.length);
        System.arraycopy(b, 0, all, a.length, b.length);
        return all;
    }

    private void print(String key, double[] values) {
        Arrays.sort(values);
        out.printf(
                Locale.ROOT,
                "| %s | %d | %.2g | %.2g | %.2g | %d |%n",
                key,
                values.length,
                values[values.length / 2],
                values[(int) (0.95 * (values.length - 1))],
                values[values.length - 1],
                Arrays.stream(values).filter(ratio -> ratio > 1).count());
    }
}
