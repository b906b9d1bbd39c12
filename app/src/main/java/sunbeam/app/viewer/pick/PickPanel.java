package sunbeam.app.viewer.pick;

import java.util.List;
import java.util.stream.Collectors;
import javax.swing.BorderFactory;
import javax.swing.BoxLayout;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import sunbeam.precompute.text.Text;

/** Panel with frames, angles, colors and spectra of the picked points and their color difference. */
public final class PickPanel extends JPanel {
    static final int MOST = 2;

    private final transient List<PickReadout> readouts = List.of(
            new PickReadout("Double-click the skin to see its\nframe, angles, color and spectrum."),
            new PickReadout(""));
    private final JLabel difference = new JLabel(" ");
    private final SpectrumPlot plot = new SpectrumPlot();

    public PickPanel() {
        setLayout(new BoxLayout(this, BoxLayout.Y_AXIS));
        setAlignmentX(LEFT_ALIGNMENT);
        setBorder(BorderFactory.createEmptyBorder(4, 0, 0, 0));
        difference.setName("difference");
        difference.setToolTipText("CIEDE2000 between both colors on screen, no unit; about 1 can just be seen");
        difference.setBorder(BorderFactory.createEmptyBorder(4, 2, 4, 2));
        JPanel colors = new JPanel();
        colors.setLayout(new BoxLayout(colors, BoxLayout.X_AXIS));
        readouts.forEach(readout -> colors.add(readout.color()));
        add(colors);
        add(difference);
        add(plot);
        readouts.forEach(readout -> add(readout.text()));
        for (var part : getComponents()) {
            ((JComponent) part).setAlignmentX(LEFT_ALIGNMENT);
        }
    }

    void show(int point, String description) {
        readouts.get(point).show(description);
    }

    void showColor(int point, int rgb) {
        readouts.get(point).showColor(rgb);
        showDifference();
    }

    private void showDifference() {
        difference.setText(differenceWords());
        difference.setVisible(readouts.get(1).color().isVisible());
    }

    private String differenceWords() {
        return readouts.get(0)
                .lab()
                .flatMap(first ->
                        readouts.get(1).lab().map(second -> Text.format("CIEDE2000 %.1f", first.difference(second))))
                .orElse(" ");
    }

    String numbers() {
        String points = readouts.stream().map(PickReadout::numbers).collect(Collectors.joining());
        return (points + (differenceWords() + "\n").stripLeading() + plot.numbers()).strip() + "\n";
    }

    void showSpectrum(int point, double[] powers) {
        plot.show(point, powers);
    }

    void awaitSpectrum(int point, boolean awaited) {
        plot.await(point, awaited);
    }

    /**
     * Removes a point's color until the next final picture.
     *
     * @param isSpectrumOld true to dim the spectrum, whose inputs have changed
     */
    void outdate(int point, boolean isSpectrumOld) {
        readouts.get(point).outdate();
        showDifference();
        plot.setOld(point, isSpectrumOld);
    }

    void clear(int point) {
        readouts.get(point).clear();
        showDifference();
        plot.show(point, new double[0]);
    }
}
