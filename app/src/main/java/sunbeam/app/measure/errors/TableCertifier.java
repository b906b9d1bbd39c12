package sunbeam.app.measure.errors;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import sunbeam.app.terminal.progress.Progress;

/** Compares random rows of a table with the exact reference. */
public final class TableCertifier {
    private final IntFunction<double[]> computed;
    private final IntFunction<double[]> exact;
    private final String quantity;

    /**
     * A certifier of one table.
     *
     * @param computed a row's X, Y, Z of power, or power alone
     * @param exact the same by the reference; thread-safe
     * @param quantity its name
     */
    public TableCertifier(IntFunction<double[]> computed, IntFunction<double[]> exact, String quantity) {
        this.computed = computed;
        this.exact = exact;
        this.quantity = quantity;
    }

    /**
     * Evaluates random rows in parallel, with progress.
     *
     * @param rows of the table
     * @param count how many of them; all, when there are fewer
     * @param tolerance what the table was made for
     */
    public Certificate certify(int rows, int count, double tolerance) {
        List<Integer> chosen = new ArrayList<>(IntStream.range(0, rows).boxed().toList());
        Collections.shuffle(chosen, new Random(CertifyOption.SEED));
        List<Integer> drawn = chosen.subList(0, Math.min(rows, count));
        try (Progress progress = Progress.start("Certificate", drawn.size())) {
            List<Comparison> compared = drawn.parallelStream()
                    .map(row -> {
                        Comparison comparison = new Comparison(computed.apply(row), exact.apply(row), 1);
                        progress.step(1);
                        return comparison;
                    })
                    .toList();
            return new Certificate(
                    drawn.size() == rows ? "all " + rows + " rows" : compared.size() + " random rows",
                    drawn.size() == rows,
                    quantity,
                    Comparison.relative(compared),
                    Comparison.relativeL2(compared),
                    ErrorStatistics.of(),
                    tolerance);
        }
    }
}
