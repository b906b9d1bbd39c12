package sunbeam.app.commands.render;

import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.io.PrintWriter;
import java.util.List;
import java.util.function.Function;
import jrtr.GraphicsException;
import jrtr.RenderContext;
import picocli.CommandLine.Option;
import sunbeam.app.measure.errors.CrawlCertificate;
import sunbeam.app.measure.errors.SceneCertificate;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.MethodType;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.setting.Choices;

/** The option that has pixels of a picture or an animation compared with the means of many points in each. */
final class PixelCertificate {
    private static final int MOST_CERTIFIED = 10_000;
    // Of the points that a picture is compared with: a quarter of what the median of its errors may be.
    private static final double CERTIFYING = 5e-3;

    @Option(
            names = "--certify",
            paramLabel = "N",
            description =
                    "Draw N random pixels of this very picture with 256 points each by method full at tolerance 5e-3 and"
                            + " state the error of the picture beside their means: median, 95th percentile and maximum of XYZ, mean and"
                            + " maximum CIEDE2000. Exit code 3 when the median exceeds 2 %% or the mean CIEDE2000 1. Of an animation,"
                            + " pixels of each two frames that follow one another, and by how much they change; exit code 3 also when"
                            + " that is a tenth more than their means do: such an animation crawls. By full and table.")
    private Integer certify;

    /** Before anything is loaded. */
    void check(List<Scene> frames) {
        if (certify == null) {
            return;
        }
        if (certify < 1 || certify > MOST_CERTIFIED) {
            throw new UsageException("--certify " + certify + " is out of range; give 1 to " + MOST_CERTIFIED);
        }
        Scene scene = frames.get(0);
        if (scene.index().isByWavelength()) {
            throw new UsageException("--certify compares one integral over wavelengths, but a picture of an index by"
                    + " wavelength is the sum of two; give a number as --index, or leave --certify out");
        }
        MethodType type = scene.method().type();
        if (scene.method().isThesis() || (type != FullMethod.TYPE && type != TableMethod.TYPE)) {
            throw new UsageException("--certify compares with method full at a tolerance, of which "
                    + (scene.method().isThesis() ? "the thesis's preset" : "method " + type)
                    + " draws another picture; leave it out");
        }
    }

    /**
     * Compares, if that is asked for, and prints a line.
     *
     * @param drawn what has been drawn
     * @param scenes of its frames
     * @param loader loads what points are drawn of
     */
    ExitCode print(
            RenderContext context,
            FrameSequence drawn,
            List<Scene> scenes,
            Function<Scene, SceneData> loader,
            PrintWriter out,
            PrintWriter err) {
        if (certify == null) {
            return ExitCode.OK;
        }
        SceneData points = loader.apply(points(scenes.get(0)));
        try {
            return compare(context, drawn, scenes, points, out, err);
        } catch (GraphicsException failure) {
            throw new GraphicsException("what was drawn is there, but cannot be compared: " + failure.getMessage()
                    + "; or leave --certify out");
        }
    }

    private ExitCode compare(
            RenderContext context,
            FrameSequence drawn,
            List<Scene> scenes,
            SceneData points,
            PrintWriter out,
            PrintWriter err) {
        if (scenes.size() == 1) {
            SceneCertificate certificate = drawn.certify(context, points, certify);
            return certificate.missed()
                    ? missed(certificate.summary(), certificate.complaint(), out, err)
                    : kept(certificate.summary(), certificate, out);
        }
        CrawlCertificate certificate = drawn.certify(context, points, scenes, certify);
        return certificate.missed()
                ? missed(certificate.summary(), certificate.complaint(), out, err)
                : kept(certificate.summary(), certificate.frames(), out);
    }

    /** Of an anti-aliased picture the body's light and the mesh's normals are part: points of it are the reference. */
    private static Scene points(Scene scene) {
        return scene.withMethod(scene.method()
                .with(Choices.none().with(Methods.METHOD, FullMethod.TYPE).with(TOLERANCE, CERTIFYING)));
    }

    private static ExitCode kept(String summary, SceneCertificate pixels, PrintWriter out) {
        out.println("certificate: " + summary);
        if (pixels.relative().count() > 0) {
            out.println("verdict: " + pixels.praise());
        }
        out.flush();
        return ExitCode.OK;
    }

    private static ExitCode missed(String summary, String complaint, PrintWriter out, PrintWriter err) {
        out.println("certificate: " + summary);
        out.flush();
        err.println(Messages.error(complaint + "; a larger --supersample or --size, or --method table, may help"));
        err.flush();
        return ExitCode.TOLERANCE_MISSED;
    }
}
