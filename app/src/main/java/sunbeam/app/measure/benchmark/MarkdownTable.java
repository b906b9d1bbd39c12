package sunbeam.app.measure.benchmark;

import java.util.ArrayList;
import java.util.List;

/** Rows of cells as a table of Markdown, whose columns stand below each other in a terminal, too. */
final class MarkdownTable {
    private final List<List<String>> rows = new ArrayList<>();

    /** A table with these columns. */
    MarkdownTable(String... header) {
        rows.add(List.of(header));
    }

    /** Adds a row of as many cells. */
    void row(String... cells) {
        if (cells.length != rows.get(0).size()) {
            throw new IllegalArgumentException(
                    cells.length + " cells for " + rows.get(0).size() + " columns");
        }
        rows.add(List.of(cells));
    }

    /** Lines, each ended. */
    @Override
    public String toString() {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < rows.size(); i++) {
            for (int column = 0; column < rows.get(i).size(); column++) {
                String cell = rows.get(i).get(column);
                text.append("| ").append(cell).append(" ".repeat(1 + width(column) - cell.length()));
            }
            text.append("|\n");
            if (i == 0) {
                for (int column = 0; column < rows.get(0).size(); column++) {
                    text.append("|").append("-".repeat(2 + width(column)));
                }
                text.append("|\n");
            }
        }
        return text.toString();
    }

    private int width(int column) {
        return rows.stream().mapToInt(row -> row.get(column).length()).max().orElseThrow();
    }
}
