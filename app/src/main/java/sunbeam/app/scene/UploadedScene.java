package sunbeam.app.scene;

import jrtr.gl.RenderContext;
import jrtr.gl.VertexBuffer;

/** What of a scene lies in graphics memory: mesh, texture, and the method with its tables. */
final class UploadedScene implements AutoCloseable {
    private final RenderContext context;
    private SceneData data;
    private VertexBuffer mesh;
    private SkinTextures body;
    private SkinSurface skin;

    /** Uploads a scene. */
    UploadedScene(RenderContext context, SceneData data) {
        this.context = context;
        try {
            update(data);
        } catch (RuntimeException | OutOfMemoryError failure) {
            close();
            throw failure;
        }
    }

    SceneData data() {
        return data;
    }

    VertexBuffer mesh() {
        return mesh;
    }

    SkinTextures body() {
        return body;
    }

    SkinSurface skin() {
        return skin;
    }

    /** What a picture of it shows. */
    SkinGeometry geometry(int width, int height) {
        Scene scene = data.scene();
        return new SkinGeometry(
                mesh,
                data.mesh().closed(),
                body,
                scene.view(),
                scene.orientation(),
                scene.rotatePatch(),
                width,
                height);
    }

    /** As {@link SceneSession#update(SceneData)}. */
    void update(SceneData next) {
        VertexBuffer nextMesh = data != null && next.sharesMesh(data) ? mesh : null;
        SkinTextures nextBody = data != null && next.sharesBody(data) ? body : null;
        SkinSurface nextSkin = data != null && next.sharesMethod(data) ? skin : null;
        try {
            nextMesh = nextMesh != null
                    ? nextMesh
                    : context.createVertexBuffer("mesh", next.mesh().toVertexData());
            nextBody = nextBody != null ? nextBody : SkinTextures.upload(context, next.body());
            nextSkin = nextSkin != null ? nextSkin : SkinSurface.create(context, next);
        } catch (RuntimeException | OutOfMemoryError failure) {
            closeUnlessSame(nextMesh, mesh);
            closeUnlessSame(nextBody, body);
            closeUnlessSame(nextSkin, skin);
            throw failure;
        }
        closeUnlessSame(mesh, nextMesh);
        closeUnlessSame(body, nextBody);
        closeUnlessSame(skin, nextSkin);
        mesh = nextMesh;
        body = nextBody;
        skin = nextSkin;
        data = next;
    }

    private static void closeUnlessSame(AutoCloseable part, AutoCloseable other) {
        try {
            if (part != null && part != other) {
                part.close();
            }
        } catch (RuntimeException failure) {
            throw failure;
        } catch (Exception failure) {
            throw new IllegalStateException("parts of a session close without checked exceptions", failure);
        }
    }

    @Override
    public void close() {
        closeUnlessSame(skin, null);
        closeUnlessSame(body, null);
        closeUnlessSame(mesh, null);
    }
}
