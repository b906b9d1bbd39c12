package sunbeam.app.files.plot;

import java.awt.Font;
import java.awt.font.FontRenderContext;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Names of files in figures, abbreviated to a width: those that are wider lose their middle, so that the figure's other parts keep their
 * size.
 */
public final class FittedNames {
    // Text is anti-aliased and letters begin at whole pixels, as in pictures.
    private static final FontRenderContext CONTEXT = new FontRenderContext(null, true, false);
    private static final String GAP = "\u2026";

    private FittedNames() {}

    /**
     * Returns the abbreviated names of one figure. Different names stay different: if only their middles differ, the later ones get a
     * number.
     *
     * @param widest largest width of a name, in pixels
     */
    public static List<String> of(List<String> names, Font font, double widest) {
        List<String> fitted = new ArrayList<>();
        Set<String> taken = new HashSet<>(names);
        for (String name : names) {
            String shown = of(name, font, widest);
            for (int number = 2; !shown.equals(name) && taken.contains(shown); number++) {
                String ending = " #" + number;
                shown = of(name, font, widest - width(ending, font)) + ending;
            }
            taken.add(shown);
            fitted.add(shown);
        }
        return fitted;
    }

    /** Returns one abbreviated name, of whose letters two thirds are from its beginning. */
    public static String of(String name, Font font, double widest) {
        int[] letters = name.codePoints().toArray();
        String shown = name;
        for (int kept = letters.length - 1; kept > 1 && width(shown, font) > widest; kept--) {
            int first = (2 * kept + 2) / 3;
            String beginning = new String(letters, 0, first).stripTrailing();
            String end = new String(letters, letters.length - kept + first, kept - first).stripLeading();
            shown = beginning + GAP + end;
        }
        return shown;
    }

    private static double width(String text, Font font) {
        return font.getStringBounds(text, CONTEXT).getWidth();
    }
}
