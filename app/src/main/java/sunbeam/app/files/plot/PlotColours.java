package sunbeam.app.files.plot;

import java.awt.Color;

/** The colours of plots' series, for what stands beside a plot and shows the same. */
public final class PlotColours {
    private PlotColours() {}

    /** Of the group or series with this number, from 0. */
    public static Color of(int number) {
        return PlotStyle.colour(number);
    }
}
