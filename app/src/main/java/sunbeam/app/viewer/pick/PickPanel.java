package sunbeam.app.viewer.pick;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.util.Locale;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.text.DefaultCaret;

/** Frame, angles, color and spectrum of the picked point. */
public final class PickPanel extends JPanel {
    private static final String HINT = "Double-click the skin to see its\nframe, angles, color and spectrum.";

    private final JTextArea text = new JTextArea(HINT, 8, 32);
    private final JLabel color = new JLabel(" ");
    private final SpectrumPlot plot = new SpectrumPlot();

    public PickPanel() {
        super(new BorderLayout(0, 6));
        setBorder(BorderFactory.createEmptyBorder(4, 12, 8, 12));
        text.setEditable(false);
        text.setOpaque(false);
        // Or else each new text would be scrolled to.
        ((DefaultCaret) text.getCaret()).setUpdatePolicy(DefaultCaret.NEVER_UPDATE);
        text.setFont(new Font(Font.MONOSPACED, Font.PLAIN, 11));
        text.setName("pick");
        text.setToolTipText("Vectors in world space, no unit; angles to the normal and around it in degrees");
        color.setOpaque(false);
        color.setPreferredSize(new Dimension(100, 22));
        color.setToolTipText("Color on screen, sRGB 0 to 255");
        add(text, BorderLayout.NORTH);
        add(color);
        add(plot, BorderLayout.SOUTH);
    }

    void show(String description) {
        text.setText(description);
    }

    void showColor(int rgb) {
        Color shown = new Color(rgb);
        color.setOpaque(true);
        color.setBackground(shown);
        boolean bright = 0.3 * shown.getRed() + 0.59 * shown.getGreen() + 0.11 * shown.getBlue() > 128;
        color.setForeground(bright ? Color.BLACK : Color.WHITE);
        color.setText(
                String.format(Locale.ROOT, "  sRGB %d, %d, %d", shown.getRed(), shown.getGreen(), shown.getBlue()));
    }

    /** All that is shown, as text; without a color and a spectrum that are out of date. */
    String numbers() {
        return (text.getText() + "\n" + color.getText().strip() + "\n" + plot.numbers()).strip() + "\n";
    }

    void showSpectrum(double[] powers) {
        plot.show(powers);
        plot.dim(false);
    }

    /** Takes the color away until there is that of the newest picture, and dims the spectrum if it is of another scene. */
    void outdate(boolean spectrum) {
        color.setOpaque(false);
        color.setText(" ");
        plot.dim(spectrum);
        repaint();
    }

    void clear() {
        text.setText(HINT);
        showSpectrum(new double[0]);
        outdate(false);
    }
}
