package sunbeam.app.cli;

import picocli.CommandLine.Option;
import sunbeam.app.files.plot.Drawing;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.units.Lengths;

/** Option {@code --column-width}: how wide a picture is printed; a picocli mixin. */
public final class PageOptions {
    private static final double NARROWEST = 0.04;
    private static final double WIDEST = 0.5;

    @Option(
            names = "--column-width",
            paramLabel = "LENGTH",
            description = "Width in print (text: 8 points). Default: 113mm.")
    private String column;

    /** Returns the width in meters. */
    public double width() {
        if (column == null) {
            return Drawing.STANDARD_WIDTH;
        }
        String remedy = "give a length from 40mm to 500mm, such as 85mm";
        double width = UsageException.parsed("--column-width: ", () -> Lengths.parse(column));
        UsageException.throwIf(!(width >= NARROWEST && width <= WIDEST), "--column-width " + column + ": " + remedy);
        return width;
    }

    /** Returns the width of a plot in pixels. */
    public int pixels() {
        return Drawing.pixels(width());
    }
}
