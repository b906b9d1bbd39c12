package sunbeam.app.viewer;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.text.DefaultCaret;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.text.Text;

/** Panel with frames, angles, colors and spectra of the picked points and their color difference. */
public final class PickPanel extends JPanel {
    private final SpectrumPlot plot = new SpectrumPlot();
    /** One for each point that can be picked. */
    public final transient List<Readout> readouts = List.of(
            new Readout("Double-click the skin to see its frame, angles, color and spectrum.", plot.curves.get(0)),
            new Readout("", plot.curves.get(1)));

    private final JLabel difference = new JLabel(" ");

    public PickPanel() {
        setLayout(new BoxLayout(this, BoxLayout.Y_AXIS));
        setAlignmentX(LEFT_ALIGNMENT);
        setBorder(BorderFactory.createEmptyBorder(4, 0, 0, 0));
        difference.setName("difference");
        difference.setToolTipText("CIEDE2000 between both colors on screen, no unit; about 1 can just be seen");
        difference.setBorder(BorderFactory.createEmptyBorder(4, 2, 4, 2));
        Box colors = Box.createHorizontalBox();
        readouts.forEach(readout -> colors.add(readout.color));
        add(colors);
        add(difference);
        add(plot);
        readouts.forEach(readout -> {
            add(readout.sentence);
            add(readout.text);
            readout.clear();
        });
        for (var part : getComponents()) {
            ((JComponent) part).setAlignmentX(LEFT_ALIGNMENT);
        }
    }

    private void showDifference() {
        Optional<CieLab> first = readouts.get(0).lab();
        Optional<CieLab> second = readouts.get(1).lab();
        boolean isKnown = first.isPresent() && second.isPresent();
        difference.setText(isKnown ? Text.format("CIEDE2000 %.1f", first.get().difference(second.get())) : " ");
        difference.setVisible(readouts.get(1).color.isVisible());
    }

    String firstSentence() {
        return readouts.get(0).sentence.getText();
    }

    public String numbers() {
        String points = readouts.stream().map(Readout::numbers).collect(Collectors.joining());
        return (points + (difference.getText() + "\n").stripLeading() + plot.numbers()).strip() + "\n";
    }

    /** Numbers of one picked point: frame, angles, color and spectrum. */
    public final class Readout {
        public final SpectrumPlot.Curve curve;
        private final String hint;
        private final JTextArea sentence = new JTextArea();
        private final JTextArea text;
        private String numbers = "";
        private final JLabel color = new JLabel(" ");
        private Color shown;

        /** @param hint text shown while no point is picked; if empty, the readout is hidden instead */
        Readout(String hint, SpectrumPlot.Curve curve) {
            this.hint = hint;
            this.curve = curve;
            text = new JTextArea();
            for (JTextArea area : List.of(sentence, text)) {
                area.setEditable(false);
                area.setOpaque(false);
                // Do not scroll to each new text.
                ((DefaultCaret) area.getCaret()).setUpdatePolicy(DefaultCaret.NEVER_UPDATE);
            }
            sentence.setLineWrap(true);
            sentence.setWrapStyleWord(true);
            sentence.setName("sentence");
            text.setFont(new Font(Font.MONOSPACED, Font.PLAIN, 11));
            text.setName("pick");
            text.setToolTipText("Vectors in world space, no unit; angles to the normal and around it in degrees");
            color.setPreferredSize(new Dimension(60, 22));
            color.setMaximumSize(new Dimension(Short.MAX_VALUE, 22));
            color.setToolTipText("Color on screen, sRGB 0 to 255");
        }

        /** Shows a sentence and a description, or of that only its last three lines, the angles; all of it is copied. */
        public void show(String words, String description, boolean isBrief) {
            numbers = description;
            List<String> lines = description.lines().toList();
            setText(sentence, words);
            setText(text, String.join("\n", isBrief ? lines.subList(lines.size() - 3, lines.size()) : lines));
            color.setVisible(true);
        }

        private static void setText(JTextArea area, String value) {
            if (!area.getText().equals(value)) {
                area.setText(value);
            }
            area.setVisible(!value.isEmpty());
        }

        public void showColor(int rgb) {
            shown = new Color(rgb);
            color.setOpaque(true);
            color.setBackground(shown);
            boolean bright = 0.3 * shown.getRed() + 0.59 * shown.getGreen() + 0.11 * shown.getBlue() > 128;
            color.setForeground(bright ? Color.BLACK : Color.WHITE);
            color.setText(Text.format("  sRGB %d, %d, %d", shown.getRed(), shown.getGreen(), shown.getBlue()));
            showDifference();
        }

        /** Returns the color on screen relative to the screen's white; empty until the newest picture is final. */
        Optional<CieLab> lab() {
            return Optional.ofNullable(shown).map(rgb -> CieLab.ofSrgb(rgb.getRGB()));
        }

        String numbers() {
            return numbers.isEmpty()
                    ? ""
                    : (sentence.getText() + "\n" + numbers + "\n"
                                            + color.getText().strip())
                                    .strip() + "\n";
        }

        /** Removes the color until the next final picture, and dims an old spectrum. */
        public void outdate(boolean isSpectrumOld) {
            shown = null;
            color.setOpaque(false);
            color.setText(" ");
            showDifference();
            curve.setOld(isSpectrumOld);
        }

        public void clear() {
            numbers = "";
            setText(sentence, hint);
            setText(text, "");
            color.setVisible(false);
            outdate(false);
            curve.show(PickedLight.Spectrum.NONE);
        }
    }
}
