package sunbeam.app.viewer;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.util.Arrays;
import java.util.Locale;
import javax.swing.JComponent;

/** Power over wavelength, 380 to 780 nm. */
final class SpectrumPlot extends JComponent {
    private static final int MARGIN = 16;

    private double[] powers = {};
    private boolean isOld;

    SpectrumPlot() {
        setPreferredSize(new Dimension(240, 100));
        setToolTipText("Diffracted power (no unit; 1 for a mirror) over wavelength (nm), by direct summation");
        setName("spectrum");
    }

    /** @param values at equal steps of wavelength; none while there is no spectrum */
    void show(double[] values) {
        powers = values.clone();
        repaint();
    }

    /** Dims a spectrum of another light or scene. */
    void dim(boolean old) {
        isOld = old;
        repaint();
    }

    @Override
    protected void paintComponent(Graphics plain) {
        Graphics2D graphics = (Graphics2D) plain.create();
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        int bottom = getHeight() - MARGIN;
        graphics.setColor(getForeground());
        graphics.setFont(getFont().deriveFont(10f));
        graphics.drawString("380 nm", 0, getHeight() - 3);
        String end = "780 nm";
        graphics.drawString(end, getWidth() - graphics.getFontMetrics().stringWidth(end), getHeight() - 3);
        graphics.setColor(new Color(128, 128, 128, 120));
        graphics.drawLine(0, bottom, getWidth(), bottom);
        double most = Arrays.stream(powers).max().orElse(0);
        if (most > 0) {
            paintCurve(graphics, bottom, most);
            graphics.setColor(getForeground());
            graphics.drawString(String.format(Locale.ROOT, "%.2g", most), 0, 10);
        }
        if (isOld) {
            graphics.setColor(PictureView.VEIL);
            graphics.fillRect(0, 0, getWidth(), getHeight());
        }
        graphics.dispose();
    }

    private void paintCurve(Graphics2D graphics, int bottom, double most) {
        Path2D curve = new Path2D.Double();
        for (int i = 0; i < powers.length; i++) {
            double x = (double) i * (getWidth() - 1) / (powers.length - 1);
            double y = bottom - powers[i] / most * (bottom - MARGIN);
            if (i == 0) {
                curve.moveTo(x, y);
            } else {
                curve.lineTo(x, y);
            }
        }
        graphics.setColor(new Color(0x5aa9e6));
        graphics.setStroke(new BasicStroke(1.5f));
        graphics.draw(curve);
    }
}
