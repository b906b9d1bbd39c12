package sunbeam.app.scene;

import java.util.Optional;
import jrtr.gl.RenderContext;
import jrtr.gl.VertexBuffer;
import jrtr.scene.SceneRenderer;
import org.joml.Vector3fc;
import sunbeam.app.scene.mesh.SkyVisibility;

/** What of a scene lies in graphics memory: mesh, texture, and the method with its tables. */
final class UploadedScene implements AutoCloseable {
    private final RenderContext context;
    private final Shadows shadows;
    private SceneData data;
    private VertexBuffer mesh;
    private SkinTextures body;
    private SkinSurface skin;
    // Where the sky's light is less on the mesh; made when a scene asks for it first.
    private boolean knowsSky;
    private Optional<Ground> ground = Optional.empty();

    /** Uploads a scene. */
    UploadedScene(RenderContext context, SceneRenderer renderer, SceneData data) {
        this.context = context;
        this.shadows = new Shadows(context, renderer);
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

    /** What is drawn where the mesh is not; with the body only. */
    Optional<Ground> ground() {
        Scene scene = data.scene();
        return scene.around().ground().isPresent() && scene.blend().hasBody() ? ground : Optional.empty();
    }

    SkinSurface skin() {
        return skin;
    }

    /** What a picture of it shows. */
    SkinGeometry geometry(int width, int height, boolean moves) {
        Scene scene = data.scene();
        Optional<Vector3fc> light =
                scene.around().shadows() ? Optional.of(scene.light().towards()) : Optional.empty();
        light.ifPresent(towards -> shadows.draw(mesh, data.mesh().closed(), scene.orientation(), towards, moves));
        // What moves finds them when it is lit: a light that moves leaves the geometry as it is.
        Optional<Vector3fc> noted = moves ? Optional.empty() : light;
        return new SkinGeometry(
                mesh,
                data.mesh().closed(),
                body,
                scene.view(),
                scene.orientation(),
                scene.rotatePatch(),
                shadows,
                noted,
                width,
                height);
    }

    /** As {@link SceneSession#update(SceneData)}. */
    void update(SceneData next) {
        boolean wantsSky = next.scene().around().occludesSky();
        boolean sameMesh = data != null && next.sharesMesh(data) && (knowsSky || !wantsSky);
        VertexBuffer nextMesh = sameMesh ? mesh : null;
        Optional<Ground> nextGround = sameMesh ? ground : Optional.empty();
        SkinTextures nextBody = data != null && next.sharesBody(data) ? body : null;
        SkinSurface nextSkin = data != null && next.sharesMethod(data) ? skin : null;
        try {
            if (nextMesh == null && wantsSky) {
                SkyVisibility seen = next.sky().get();
                nextMesh = context.createVertexBuffer("mesh", next.mesh().toVertexData(seen.ofVertices()));
                nextGround = Optional.of(Ground.create(context, SkyVisibility.ground(next.mesh()), seen));
            } else if (nextMesh == null) {
                nextMesh = context.createVertexBuffer("mesh", next.mesh().toVertexData());
            }
            nextBody = nextBody != null ? nextBody : SkinTextures.upload(context, next.body());
            nextSkin = nextSkin != null ? nextSkin : SkinSurface.create(context, next);
        } catch (RuntimeException | OutOfMemoryError failure) {
            closeUnlessSame(nextMesh, mesh);
            closeUnlessSame(nextGround.orElse(null), ground.orElse(null));
            closeUnlessSame(nextBody, body);
            closeUnlessSame(nextSkin, skin);
            throw failure;
        }
        closeUnlessSame(mesh, nextMesh);
        closeUnlessSame(ground.orElse(null), nextGround.orElse(null));
        knowsSky = sameMesh ? knowsSky : wantsSky;
        ground = nextGround;
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
        ground.ifPresent(Ground::close);
        shadows.close();
    }
}
