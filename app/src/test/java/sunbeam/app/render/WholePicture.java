package sunbeam.app.render;

/** Draws whole pictures. */
public final class WholePicture {
    private WholePicture() {}

    public static ScenePicture of(SceneSession session, int width, int height) {
        ScenePicture picture = ScenePicture.empty(width, height);
        for (DrawRequest part : SceneSession.parts(session.scene(), width, height, 1)) {
            picture.put(session.draw(part), part.tile().x(), part.tile().y());
        }
        return picture;
    }
}
