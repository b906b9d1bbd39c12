package sunbeam.app.viewer;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Path2D;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import javax.swing.JComponent;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.Tone;
import sunbeam.precompute.text.Text;

/** Plot of power over wavelength, 380 to 780 nm, in the colors of the wavelengths, with a readout under the mouse. */
public final class SpectrumPlot extends JComponent {
    private static final int MARGIN = 16;
    private static final int STRIP = 6;
    /** Number of wavelengths of a spectrum, in equal steps from 380 to 780 nm. */
    public static final int COUNT = 81;

    private static final double RANGE = 400e-9;
    private static final String AWAITED = "Spectrum: being made";
    private static final String REFINED = "each 40 nm, others follow";
    private static final String MIXED = "its X, Y, Z follow";
    private static final Color OLD = new Color(0x60686f);
    private static final CieTable LIGHT = CieTable.load();
    // Exposure at which the brightest wavelength reaches the screen's maximum.
    private static final DisplayTransform DISPLAY = new DisplayTransform(1 / LIGHT.at(555e-9, 1), Tone.COMPRESS);

    final transient List<Curve> curves = List.of(
            new Curve(new Color(0x5aa9e6), new BasicStroke(1.5f)),
            new Curve(
                    new Color(0xf0a050),
                    new BasicStroke(1.5f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {5, 3}, 0)));
    private int pointed = -1;

    /** Spectrum of one picked point. */
    public final class Curve {
        private final Color color;
        private final BasicStroke stroke;
        private double[] powers = {};
        private String xyz = "";
        private boolean isOld;
        private boolean isAwaited;

        Curve(Color color, BasicStroke stroke) {
            this.color = color;
            this.stroke = stroke;
        }

        /** Sets whether the spectrum is being made. */
        public void await(boolean awaited) {
            isAwaited = awaited;
            repaint();
        }

        /** Shows a spectrum, which is still awaited if it is partial; an empty one clears the curve. */
        public void show(PickedLight.Spectrum spectrum) {
            powers = spectrum.powers().clone();
            xyz = spectrum.color();
            isOld = false;
            await(powers.length > 0 && xyz.isEmpty());
        }

        private String awaited() {
            return powers.length == 0 ? AWAITED : powers.length < COUNT ? REFINED : MIXED;
        }

        void setOld(boolean old) {
            isOld = old;
            repaint();
        }
    }

    SpectrumPlot() {
        setMinimumSize(new Dimension(120, 70));
        setPreferredSize(new Dimension(240, 100));
        setMaximumSize(new Dimension(Short.MAX_VALUE, 180));
        setToolTipText("Diffracted power (no unit; 1 for a mirror) over wavelength (nm), by direct summation");
        setName("spectrum");
        MouseAdapter mouse = new MouseAdapter() {
            @Override
            public void mouseMoved(MouseEvent event) {
                point(event.getX());
            }

            @Override
            public void mouseExited(MouseEvent event) {
                point(-1);
            }
        };
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
    }

    /** Returns a wavelength of spectra in meters. */
    public static double wavelength(int index) {
        return CieTable.MINIMUM_WAVELENGTH + RANGE * index / (COUNT - 1);
    }

    /** Returns the linearly interpolated power at a share of the wavelength axis, 0 to 1. */
    private static double at(double[] powers, double share) {
        double at = share * (powers.length - 1);
        int below = (int) Math.max(0, Math.min(powers.length - 2.0, at));
        return powers[below] + (at - below) * (powers[below + 1] - powers[below]);
    }

    private void point(int column) {
        pointed = column;
        repaint();
    }

    /** Returns colors and powers as text, one wavelength per line; empty if absent or outdated. */
    String numbers() {
        List<Curve> known = curves.stream()
                .filter(curve -> curve.powers.length == COUNT && !curve.isOld)
                .toList();
        if (known.isEmpty()) {
            return "";
        }
        StringBuilder text = new StringBuilder();
        known.stream()
                .filter(curve -> !curve.xyz.isEmpty())
                .forEach(curve -> text.append(curve.xyz).append('\n'));
        text.append("wavelength (nm)").append("\tpower".repeat(known.size()));
        for (int i = 0; i < COUNT; i++) {
            text.append(Text.format("\n%.0f", 1e9 * wavelength(i)));
            for (Curve curve : known) {
                text.append(Text.format("\t%.6g", curve.powers[i]));
            }
        }
        return text.toString();
    }

    @Override
    protected void paintComponent(Graphics plain) {
        Graphics2D graphics = (Graphics2D) plain.create();
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        int bottom = getHeight() - MARGIN - STRIP;
        paintStrip(graphics, bottom + 1);
        graphics.setColor(getForeground());
        graphics.setFont(getFont().deriveFont(10f));
        graphics.drawString("380 nm", 0, getHeight() - 3);
        String end = "780 nm";
        graphics.drawString(end, getWidth() - graphics.getFontMetrics().stringWidth(end), getHeight() - 3);
        graphics.setColor(new Color(128, 128, 128, 120));
        graphics.drawLine(0, bottom, getWidth(), bottom);
        double most = curves.stream()
                .flatMapToDouble(curve -> Arrays.stream(curve.powers))
                .max()
                .orElse(0);
        if (most > 0) {
            for (Curve curve : curves) {
                paintCurve(graphics, bottom, most, curve);
            }
            graphics.setColor(getForeground());
            graphics.drawString(Text.format("%.2g of a mirror's light", most), 0, 10);
            paintPointed(graphics, bottom);
        }
        curves.stream().filter(curve -> curve.isAwaited).findFirst().ifPresent(curve -> {
            graphics.setFont(getFont().deriveFont(11f));
            FontMetrics metrics = graphics.getFontMetrics();
            graphics.setColor(getForeground());
            int row = most > 0 ? getHeight() - 3 : (bottom + metrics.getAscent()) / 2;
            String words = curve.awaited();
            graphics.drawString(words, (getWidth() - metrics.stringWidth(words)) / 2, row);
        });
        graphics.dispose();
    }

    private void paintStrip(Graphics2D graphics, int top) {
        double[] xyz = new double[3];
        for (int x = 0; x < getWidth(); x++) {
            for (int c = 0; c < 3; c++) {
                xyz[c] = LIGHT.at(CieTable.MINIMUM_WAVELENGTH + RANGE * share(x), c);
            }
            graphics.setColor(new Color(DISPLAY.rgb(xyz)));
            graphics.fillRect(x, top, 1, STRIP);
        }
    }

    private double share(int x) {
        return (double) x / Math.max(1, getWidth() - 1);
    }

    private void paintPointed(Graphics2D graphics, int bottom) {
        if (pointed < 0 || pointed >= getWidth()) {
            return;
        }
        graphics.drawLine(pointed, MARGIN, pointed, bottom);
        double nanometers = 1e9 * (CieTable.MINIMUM_WAVELENGTH + RANGE * share(pointed));
        String words = curves.stream()
                .filter(curve -> curve.powers.length > 0)
                .map(curve -> Text.format("%.3g", at(curve.powers, share(pointed))))
                .collect(Collectors.joining(", ", Text.format("%.0f nm: ", nanometers), ""));
        graphics.drawString(words, getWidth() - graphics.getFontMetrics().stringWidth(words), 10);
    }

    private void paintCurve(Graphics2D graphics, int bottom, double most, Curve curve) {
        double[] powers = curve.powers;
        Path2D line = new Path2D.Double();
        for (int i = 0; i < powers.length; i++) {
            double x = (double) i * (getWidth() - 1) / (powers.length - 1);
            double y = bottom - powers[i] / most * (bottom - MARGIN);
            if (i == 0) {
                line.moveTo(x, y);
            } else {
                line.lineTo(x, y);
            }
        }
        graphics.setColor(curve.isOld ? OLD : curve.color);
        graphics.setStroke(curve.stroke);
        graphics.draw(line);
    }
}
