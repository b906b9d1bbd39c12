package sunbeam.app.files.plot;

import java.awt.Color;

/** The colors of plots' series, for what stands beside a plot and shows the same. */
public final class PlotColors {
    private PlotColors() {}

    /** Of the group or series with this number, from 0. */
    public static Color of(int number) {
        return PlotStyle.color(number);
    }
}
