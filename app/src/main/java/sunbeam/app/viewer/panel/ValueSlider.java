package sunbeam.app.viewer.panel;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.function.Consumer;
import java.util.function.DoubleFunction;
import java.util.function.DoubleUnaryOperator;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.JTextField;

/** Slider with an editable value field. Both report changes as text; a double click resets. */
final class ValueSlider extends JPanel {
    private final JSlider slider;
    private final JTextField value = new JTextField(5);
    private final transient DoubleUnaryOperator toSlider;
    private final transient DoubleFunction<String> text;
    private boolean updating;

    /**
     * @param fromSlider converts a slider position to the quantity
     * @param toSlider converts the quantity to a slider position
     * @param text formats the quantity as the value field shows and accepts it
     * @param standard text that a double click on the slider enters
     * @param entered receives the text of each change
     */
    ValueSlider(
            String name,
            int low,
            int high,
            DoubleUnaryOperator fromSlider,
            DoubleUnaryOperator toSlider,
            DoubleFunction<String> text,
            String standard,
            Consumer<String> entered) {
        super(new BorderLayout(6, 0));
        this.toSlider = toSlider;
        this.text = text;
        slider = new JSlider(low, high);
        slider.setName(name);
        slider.setPreferredSize(new Dimension(110, slider.getPreferredSize().height));
        add(slider);
        add(value, BorderLayout.EAST);
        slider.addChangeListener(event -> {
            if (!updating) {
                entered.accept(text.apply(fromSlider.applyAsDouble(slider.getValue())));
            }
        });
        value.addActionListener(event -> entered.accept(value.getText()));
        slider.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseReleased(MouseEvent event) {
                if (event.getClickCount() == 2) {
                    entered.accept(standard);
                }
            }
        });
    }

    void follow(double quantity) {
        updating = true;
        slider.setValue((int) Math.round(toSlider.applyAsDouble(quantity)));
        String now = text.apply(quantity);
        if (!value.getText().equals(now)) {
            value.setText(now);
        }
        updating = false;
    }

    @Override
    public void setToolTipText(String tip) {
        super.setToolTipText(tip);
        slider.setToolTipText(tip);
        value.setToolTipText(tip);
    }
}
