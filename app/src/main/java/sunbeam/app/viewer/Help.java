package sunbeam.app.viewer;

import java.util.List;
import java.util.stream.Stream;

/**
 * What mouse and keys do, as the viewer's list and docs/viewer.md show it.
 *
 * @param input a gesture, or keys
 * @param words what it does
 */
record Help(String input, String words) {
    /** Of the mouse, then of the keys. */
    static List<Help> rows() {
        return Stream.concat(
                        Stream.of(MouseAction.values()).map(action -> new Help(action.gesture(), action.words())),
                        Stream.of(Action.values()).map(action -> new Help(action.keyWords(), action.words())))
                .toList();
    }
}
