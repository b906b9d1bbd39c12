package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static sunbeam.app.viewer.Pictures.different;

import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTextArea;
import org.joml.Quaternionf;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import sunbeam.app.render.Pick;
import sunbeam.app.scene.PatchAtlas;
import sunbeam.app.scene.Placement;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneObject;
import sunbeam.app.scene.SceneSettings;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.text.Text;

/** The panel and the BRDF map of a point picked by a double click, in a real window. */
@Tag("window")
final class ViewerPickWindowTest extends ViewerInAWindow {
    private static final int CURVE = 0x5aa9e6;
    private static final int SECOND_CURVE = 0xf0a050;

    @Test
    void thePickedPointLiesUnderTheMouseAndItsFrameIsTheCylinders() throws Exception {
        Pick pick = doubleClick();
        Vector3f seen = scene().view().camera().worldToCamera().transformPosition(pick.position(), new Vector3f());
        double focal = 0.5
                * picture().getHeight()
                / scene().view().halfHeight(picture().getWidth(), picture().getHeight());
        // The mouse is somewhere in its pixel.
        assertThat(seen.x / -seen.z * focal).as("columns from the middle").isCloseTo(0, within(1.0));
        assertThat(seen.y / -seen.z * focal).as("rows from the middle").isCloseTo(0, within(1.0));
        assertThat(pick.normal().z()).as("the axis is z").isCloseTo(0, within(1e-3f));
        Vector3f outwards = new Vector3f(pick.position().x(), pick.position().y(), 0).normalize();
        // Normals are interpolated over the mesh's flat facets.
        assertThat(pick.normal().dot(outwards)).isCloseTo(1, within(1e-3f));
        assertThat(pick.tangent().dot(pick.normal())).isCloseTo(0, within(1e-4f));
        assertThat(pick.tangent().cross(pick.bitangent(), new Vector3f()).dot(pick.normal()))
                .as("orthonormal and right-handed: -1 or 1")
                .isCloseTo(1, within(1e-3f));
        Vector3fc light = scene().light().towards();
        assertThat(pick.wi().z()).isCloseTo(light.dot(outwards), within(1e-3));
        assertTheNumbersFitAWindowThatIsJustOpened();
        pickBeside();
        assertTheNumbersFitAWindowThatIsJustOpened();
    }

    private void pickBeside() throws Exception {
        middle(-80);
        click(1);
        middle(24);
        robot.keyPress(KeyEvent.VK_SHIFT);
        click(2);
        robot.keyRelease(KeyEvent.VK_SHIFT);
        awaitOnEvents(() -> viewer.inspector.points().size() == 2);
        awaitFinal();
    }

    private void assertTheNumbersFitAWindowThatIsJustOpened() throws Exception {
        // The panel is whole: its last line comes with the spectrum.
        awaitOnEvents(() -> viewer.window.pick.numbers().contains("diffracted XYZ"));
        onEvents(() -> {
            viewer.presenter.toggle(Overlay.MAP);
            viewer.window.setSize(1180, 880);
            viewer.window.validate();
            // Texts wrap at their new width.
            viewer.window.pick.revalidate();
            viewer.window.validate();
            assertThat(viewer.window.map.isVisible()).isTrue();
            JComponent panel = viewer.window.pick;
            assertThat(panel.getVisibleRect().getSize())
                    .as("what is seen without scrolling")
                    .isEqualTo(panel.getSize());
            assertThat(panel.getHeight())
                    .as("nothing is squeezed")
                    .isGreaterThanOrEqualTo(panel.getMinimumSize().height);
            viewer.window.setSize(620, 420);
            viewer.presenter.toggle(Overlay.MAP);
        });
    }

    @Test
    void thePanelFollowsThePickedObject() throws Exception {
        Placement aside = new Placement(new Vector3f(0.2f, 0, 0), new Quaternionf(), OptionalDouble.of(0.05));
        SceneObject ball = new SceneObject(
                scene().with(SceneSettings.MESH, "sphere").settings(),
                PatchAtlas.of(PatchRequest.of("lamellar")),
                aside);
        Scene both = scene().withObjects(List.of(ball, scene().objects().get(0)));
        onEvents(() -> viewer.model.open(both, () -> {}));
        awaitOnEvents(() -> viewer.model.loaded().orElseThrow().parts().size() == 2);
        assertThat(modelScene().patch().patch()).isEqualTo("lamellar");

        assertThat(doubleClick().object()).isEqualTo(1);

        assertThat(modelScene().current()).isEqualTo(1);
        assertThat(modelScene().patch().patch()).isEqualTo("blaze");
        assertThat(panelText()).contains("object     2 of 2, cylinder");
    }

    @Test
    void thePanelShowsFrameAnglesColorAndSpectrumAndFollowsTheLight() throws Exception {
        assertThat(curvePixels(CURVE)).as("no spectrum yet").isZero();
        Pick pick = doubleClick();
        String text = panelText();
        assertThat(text)
                .contains("normal     " + words(pick.normal()))
                .contains("tangent    " + words(pick.tangent()))
                .contains("bitangent  " + words(pick.bitangent()))
                .contains("light      theta " + degrees(pick.wi()))
                .contains("viewer     theta " + degrees(pick.wr()));
        BufferedImage shown = picture();
        awaitColor(shown.getRGB(shown.getWidth() / 2, shown.getHeight() / 2));
        await(() -> curvePixels(CURVE) > 100);
        BufferedImage spectrum = onEvents(() -> painted(plot()));
        assertTheNumbersAreCopied(text);
        BufferedImage marked = paintedPicture();
        // The ring of the mark is six pixels around the point.
        int row = shown.getHeight() / 2;
        assertThat(marked.getSubimage(shown.getWidth() / 2 - 9, row - 9, 18, 18))
                .satisfies(part -> assertThat(
                                different(part, shown.getSubimage(shown.getWidth() / 2 - 9, row - 9, 18, 18), false))
                        .as("pixels of the mark")
                        .isPositive());

        press(KeyEvent.VK_RIGHT);
        await(() -> !panelText().equals(text));
        awaitFinal();
        assertThat(panelText()).contains("normal     " + words(pick.normal()));
        awaitColor(picture().getRGB(shown.getWidth() / 2, shown.getHeight() / 2));
        await(() -> different(onEvents(() -> painted(plot())), spectrum, false) > 0);
        assertASecondPointStandsBesideTheFirst();
    }

    @Test
    void theMapIsThatOfThePickedPointAndOfTheNewestLight() throws Exception {
        onEvents(() -> viewer.presenter.toggle(Overlay.MAP));
        BufferedImage facing = map();
        doubleClick();
        BufferedImage picked = map();
        assertThat(different(facing, picked, false)).as("pixels with the ring").isPositive();
        press(KeyEvent.VK_UP);
        awaitFinal();
        assertThat(different(picked, map(), false))
                .as("orders of another light")
                .isPositive();
        onEvents(() -> viewer.model.change(scene -> scene.with(SceneSettings.ENVIRONMENT, "window")));
        awaitOnEvents(() -> viewer.window.pick.firstSentence().contains("brightest light "));
        assertThat(panelText()).contains("brightest  theta ").doesNotContain("light      theta");
    }

    private BufferedImage map() throws Exception {
        awaitOnEvents(() -> viewer.window.map.isNewest);
        return onEvents(() -> painted(viewer.window.map));
    }

    private void assertASecondPointStandsBesideTheFirst() throws Exception {
        SkinPoint first = onEvents(() -> viewer.inspector.point().orElseThrow());
        pickBeside();
        await(() -> curvePixels(SECOND_CURVE) > 20 && curvePixels(CURVE) > 100);
        assertThat(onEvents(() -> viewer.inspector.points()))
                .hasSize(2)
                .element(0)
                .isEqualTo(first);
        BufferedImage shown = picture();
        int row = shown.getHeight() / 2;
        double expected = CieLab.ofSrgb(shown.getRGB(shown.getWidth() / 2, row))
                .difference(CieLab.ofSrgb(shown.getRGB(shown.getWidth() / 2 + 24, row)));
        String words = Text.format("CIEDE2000 %.1f", expected);
        awaitOnEvents(() -> Dialogs.all(viewer.window.pick, JLabel.class).stream()
                .anyMatch(label -> label.getText().equals(words)));
        press(KeyEvent.VK_CONTROL, KeyEvent.VK_C);
        await(() -> message().startsWith("copied both"));
        assertThat(copied().lines().filter(line -> line.matches("[0-9]{3}\t[^\t]+\t[^\t]+")))
                .as("powers of both points")
                .hasSize(81);
        assertThat(copied()).contains(words);
    }

    private String copied() throws Exception {
        return onEvents(
                () -> (String) Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.stringFlavor));
    }

    private void assertTheNumbersAreCopied(String text) throws Exception {
        awaitOnEvents(() -> viewer.window.pick.numbers().contains("diffracted XYZ"));
        BufferedImage before = screen(viewer.window.status);
        press(KeyEvent.VK_CONTROL, KeyEvent.VK_C);
        await(() -> message().startsWith("copied"));
        JComponent view = viewer.window.picture;
        awaitOnEvents(() -> Dialogs.all(view, JTextArea.class).get(0).getVisibleRect().height > 10);
        assertThat(onEvents(view::getHeight))
                .as("the picture keeps its size")
                .isEqualTo(picture().getHeight());
        assertThat(different(before, screen(viewer.window.status), false))
                .as("what is said covers nothing of the status line")
                .isZero();
        String copied = copied();
        assertThat(copied).contains(text, "sRGB ", "diffracted XYZ, D65");
        String sentence = onEvents(() -> Dialogs.find(
                        viewer.window.pick, JTextArea.class, area -> "sentence".equals(area.getName()))
                .getText());
        assertThat(copied).startsWith(sentence);
        assertThat(sentence).matches("(?s)[a-z ]+(, .* order of [0-9.]+ um|, the mirror's direction)?; light at .*");
        assertThat(copied.lines().filter(line -> line.matches("[0-9]{3}\t.*")))
                .as("380 to 780 nm in steps of 5")
                .hasSize(81);
    }

    private String panelText() throws Exception {
        return onEvents(() -> Dialogs.find(viewer.window.pick, JTextArea.class, area -> "pick".equals(area.getName()))
                .getText());
    }

    private void awaitColor(int rgb) throws Exception {
        String words = Text.format("sRGB %d, %d, %d", rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255);
        awaitOnEvents(() -> Dialogs.all(viewer.window.pick, JLabel.class).stream()
                .anyMatch(label -> label.getText().contains(words)));
    }

    private JComponent plot() {
        return Dialogs.all(viewer.window.pick, SpectrumPlot.class).get(0);
    }

    private long curvePixels(int color) throws Exception {
        BufferedImage plot = onEvents(() -> painted(plot()));
        return Arrays.stream(Pictures.pixels(plot))
                .filter(rgb -> (rgb & 0xffffff) == color)
                .count();
    }

    private static String words(Vector3fc vector) {
        return Text.format("(%.3f, %.3f, %.3f)", vector.x(), vector.y(), vector.z());
    }

    private static String degrees(Direction direction) {
        double theta = Math.toDegrees(Math.atan2(Math.hypot(direction.x(), direction.y()), direction.z()));
        return Text.format("%.1f°", theta);
    }
}
