package sunbeam.app.viewer;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.util.function.DoubleConsumer;
import java.util.function.DoubleFunction;
import java.util.function.DoubleUnaryOperator;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;

/** A slider with its value beside it. */
final class LabelledSlider extends JPanel {
    private final JSlider slider;
    private final JLabel value = new JLabel();
    private final transient DoubleUnaryOperator toSlider;
    private final transient DoubleFunction<String> text;
    private boolean updating;

    /**
     * @param fromSlider from the slider's steps to the quantity
     * @param toSlider and back
     * @param text the quantity with its unit
     */
    LabelledSlider(
            String name,
            int low,
            int high,
            DoubleUnaryOperator fromSlider,
            DoubleUnaryOperator toSlider,
            DoubleFunction<String> text,
            DoubleConsumer changed) {
        super(new BorderLayout(6, 0));
        this.toSlider = toSlider;
        this.text = text;
        slider = new JSlider(low, high);
        slider.setName(name);
        value.setText("3.28e+04 ");
        value.setPreferredSize(value.getPreferredSize());
        slider.setPreferredSize(new Dimension(110, slider.getPreferredSize().height));
        add(slider);
        add(value, BorderLayout.EAST);
        slider.addChangeListener(event -> {
            if (!updating) {
                double quantity = fromSlider.applyAsDouble(slider.getValue());
                value.setText(text.apply(quantity));
                changed.accept(quantity);
            }
        });
    }

    /** Follows the scene; tells nobody. */
    void follow(double quantity) {
        updating = true;
        slider.setValue((int) Math.round(toSlider.applyAsDouble(quantity)));
        value.setText(text.apply(quantity));
        updating = false;
    }

    @Override
    public void setToolTipText(String tip) {
        super.setToolTipText(tip);
        slider.setToolTipText(tip);
    }

    @Override
    public void setEnabled(boolean enabled) {
        super.setEnabled(enabled);
        slider.setEnabled(enabled);
        value.setEnabled(enabled);
    }
}
