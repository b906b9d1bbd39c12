package sunbeam.app.viewer.window;

import java.util.List;
import javax.swing.filechooser.FileNameExtensionFilter;

/** ValueKind of files that the viewer loads and saves, with the names and filters of its dialogs. */
public enum FileKind {
    SCENE("scene", "json"),
    PATCH(
            "patch (descriptor, image or scan)",
            "json png jpg jpeg bmp gif tif tiff gwy gsf spm nid mi sur sdf npy x3p jpk ibw txt csv asc xyz"),
    MESH("mesh", "obj ply glb gltf"),
    TEXTURE("texture", "png jpg jpeg bmp gif"),
    PICTURE("picture", "png");

    private final String words;

    @SuppressWarnings("ImmutableEnumChecker") // a private copy
    private final List<String> endings;

    FileKind(String words, String endings) {
        this.words = words;
        this.endings = List.of(endings.split(" ", -1));
    }

    /** Returns the name of this kind in dialog titles, such as "mesh" in "Load mesh". */
    String words() {
        return words;
    }

    String ending() {
        return "." + endings.get(0);
    }

    FileNameExtensionFilter filter() {
        return new FileNameExtensionFilter(
                words + " (." + String.join(", .", endings.subList(0, Math.min(4, endings.size())))
                        + (endings.size() > 4 ? ", ..." : "") + ")",
                endings.toArray(String[]::new));
    }
}
