package sunbeam.app.viewer.pick;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.util.Optional;
import javax.swing.JLabel;
import javax.swing.JTextArea;
import javax.swing.text.DefaultCaret;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.text.Text;

/** Text of one picked point: frame, angles and color. */
final class PickReadout {
    private final String hint;
    private final JTextArea text;
    private final JLabel color = new JLabel(" ");
    private Color shown;

    /** @param hint text shown while no point is picked; if empty, the readout is hidden instead */
    PickReadout(String hint) {
        this.hint = hint;
        text = new JTextArea(hint, 8, 32) {
            @Override
            public Dimension getMaximumSize() {
                return new Dimension(Short.MAX_VALUE, getPreferredSize().height);
            }
        };
        text.setEditable(false);
        text.setOpaque(false);
        // Do not scroll to each new text.
        ((DefaultCaret) text.getCaret()).setUpdatePolicy(DefaultCaret.NEVER_UPDATE);
        text.setFont(new Font(Font.MONOSPACED, Font.PLAIN, 11));
        text.setName("pick");
        text.setToolTipText("Vectors in world space, no unit; angles to the normal and around it in degrees");
        color.setPreferredSize(new Dimension(60, 22));
        color.setMaximumSize(new Dimension(Short.MAX_VALUE, 22));
        color.setToolTipText("Color on screen, sRGB 0 to 255");
        follow();
    }

    private void follow() {
        text.setVisible(!text.getText().isEmpty());
        color.setVisible(!text.getText().equals(hint));
    }

    JTextArea text() {
        return text;
    }

    JLabel color() {
        return color;
    }

    void show(String description) {
        text.setText(description);
        follow();
    }

    void showColor(int rgb) {
        shown = new Color(rgb);
        color.setOpaque(true);
        color.setBackground(shown);
        boolean bright = 0.3 * shown.getRed() + 0.59 * shown.getGreen() + 0.11 * shown.getBlue() > 128;
        color.setForeground(bright ? Color.BLACK : Color.WHITE);
        color.setText(Text.format("  sRGB %d, %d, %d", shown.getRed(), shown.getGreen(), shown.getBlue()));
    }

    /** Returns the color on screen relative to the screen's white; empty until the newest picture is final. */
    Optional<CieLab> lab() {
        return Optional.ofNullable(shown).map(rgb -> CieLab.ofSrgb(rgb.getRGB()));
    }

    String numbers() {
        return !text.getText().equals(hint)
                ? (text.getText() + "\n" + color.getText().strip()).strip() + "\n"
                : "";
    }

    void outdate() {
        shown = null;
        color.setOpaque(false);
        color.setText(" ");
    }

    void clear() {
        text.setText(hint);
        follow();
        outdate();
    }
}
