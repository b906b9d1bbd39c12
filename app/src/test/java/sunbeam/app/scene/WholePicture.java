package sunbeam.app.scene;

import jrtr.Tile;

/** Pictures as a whole. */
public final class WholePicture {
    private WholePicture() {}

    /** Draws one, tile by tile. */
    public static ScenePicture of(SceneSession session, int width, int height) {
        ScenePicture picture = ScenePicture.empty(width, height);
        for (Tile tile : SceneSession.tiles(width, height, 1)) {
            picture.put(session.draw(width, height, tile), tile.x(), tile.y());
        }
        return picture;
    }
}
