package sunbeam.app.commands.figures;

import java.util.List;

/**
 * One of the thesis's figures.
 *
 * @param number in the thesis, for example 5.10
 * @param title what it shows
 * @param text what to see in it
 * @param panels its pictures in order
 */
record Figure(String number, String title, String text, List<Panel> panels) {
    Figure {
        panels = List.copyOf(panels);
    }
}
