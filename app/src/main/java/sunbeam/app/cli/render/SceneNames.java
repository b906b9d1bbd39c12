package sunbeam.app.cli.render;

import java.util.Iterator;
import sunbeam.app.scene.Scenes;

/** Names of the built-in scenes, which help texts list as {@code ${COMPLETION-CANDIDATES}}. */
public final class SceneNames implements Iterable<String> {
    @Override
    public Iterator<String> iterator() {
        return Scenes.builtIn().iterator();
    }
}
