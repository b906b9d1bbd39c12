package sunbeam.app.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.util.Locale;
import org.knowm.xchart.style.Styler.LegendPosition;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;
import sunbeam.app.plot.Plot.Scale;

/** The one look of all plots: white, sans serif, thin grid, colours that colour-blind people can tell apart. */
final class PlotStyle {
    /** M. Okabe and K. Ito, "Color Universal Design" (2008), without the yellow, which is too pale on white. */
    private static final Color[] COLOURS = {
        new Color(0x0072B2),
        new Color(0xD55E00),
        new Color(0x009E73),
        new Color(0xCC79A7),
        new Color(0xE69F00),
        new Color(0x56B4E9),
        new Color(0x000000)
    };

    /** Marks differ too, for print in grey. */
    private static final Marker[] MARKERS = {
        SeriesMarkers.CIRCLE,
        SeriesMarkers.SQUARE,
        SeriesMarkers.TRIANGLE_UP,
        SeriesMarkers.DIAMOND,
        SeriesMarkers.TRIANGLE_DOWN,
        SeriesMarkers.CROSS,
        SeriesMarkers.PLUS
    };

    static final Color INK = new Color(0x222222);
    /** Vermillion, seen on dark and on light. */
    static final Color MARK = new Color(0xD55E00);

    static final Font TITLE_FONT = new Font(Font.SANS_SERIF, Font.BOLD, 18);
    static final Font LABEL_FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 16);
    static final Font TICK_FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 14);

    private static final Color GRID = new Color(0xDDDDDD);
    private static final float LINE_WIDTH = 2f;

    private PlotStyle() {}

    /** The mark of the series with this index. */
    static Marker marker(int index) {
        return MARKERS[index % MARKERS.length];
    }

    static void apply(XYStyler style, Scale x, Scale y) {
        applyFonts(style);
        applyColours(style);
        style.setLocale(Locale.ROOT);
        style.setAntiAlias(true);
        style.setTextAntiAlias(true);
        style.setMarkerSize(8);
        style.setChartPadding(16);
        style.setPlotMargin(0);
        style.setLegendPosition(LegendPosition.OutsideE);
        style.setXAxisLogarithmic(x == Scale.LOGARITHMIC);
        style.setYAxisLogarithmic(y == Scale.LOGARITHMIC);
        if (x == Scale.LOGARITHMIC) {
            style.setXAxisTickLabelsFormattingFunction(PlotStyle::powerOfTen);
        }
        if (y == Scale.LOGARITHMIC) {
            style.setYAxisTickLabelsFormattingFunction(PlotStyle::powerOfTen);
        }
    }

    private static void applyFonts(XYStyler style) {
        style.setBaseFont(TICK_FONT);
        style.setChartTitleFont(TITLE_FONT);
        style.setAxisTitleFont(LABEL_FONT);
        style.setAxisTickLabelsFont(TICK_FONT);
        style.setLegendFont(TICK_FONT);
    }

    private static void applyColours(XYStyler style) {
        style.setChartBackgroundColor(Color.WHITE);
        style.setPlotBackgroundColor(Color.WHITE);
        style.setChartFontColor(INK);
        style.setPlotBorderColor(INK);
        style.setPlotGridLinesColor(GRID);
        style.setPlotGridLinesStroke(new BasicStroke(1));
        style.setLegendBorderColor(Color.WHITE);
        style.setSeriesColors(COLOURS);
        style.setSeriesLines(new BasicStroke[] {new BasicStroke(LINE_WIDTH)});
    }

    /** Whole powers of ten as 1e-3, others as 0.02 or 2e-5. */
    static String powerOfTen(double value) {
        double exponent = Math.log10(value);
        long whole = Math.round(exponent);
        boolean isPower = Math.abs(exponent - whole) < 1e-9;
        if (isPower && whole >= 0 && whole <= 3) {
            return String.format(Locale.ROOT, "%.0f", value);
        }
        return isPower ? "1e" + whole : String.format(Locale.ROOT, "%.2g", value);
    }
}
