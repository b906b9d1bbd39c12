package sunbeam.app.cli.render;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import sunbeam.app.files.input.ImageFile;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Overwrite;

/** Writer of an endless animated GIF; each frame has its own palette of 256 colors, which ImageIO's writer chooses. */
final class GifAnimation {
    private static final String FRAME_FORMAT = "javax_imageio_gif_image_1.0";

    private GifAnimation() {}

    /** Writes the animation; the frames' files are read one by one. */
    static void write(Path target, Overwrite overwrite, List<Path> frames, double framesPerSecond) {
        int hundredths = (int) Math.max(2, Math.round(100 / framesPerSecond));
        AtomicFile.write(target, overwrite, stream -> write(stream, frames, hundredths));
    }

    private static void write(OutputStream stream, List<Path> frames, int hundredths) throws IOException {
        ImageWriter writer = ImageIO.getImageWritersByFormatName("gif").next();
        try (MemoryCacheImageOutputStream output = new MemoryCacheImageOutputStream(stream)) {
            writer.setOutput(output);
            writer.prepareWriteSequence(null);
            for (int i = 0; i < frames.size(); i++) {
                BufferedImage image = ImageFile.ours(frames.get(i), "remove it and use --resume");
                IIOMetadata metadata =
                        writer.getDefaultImageMetadata(new ImageTypeSpecifier(image), writer.getDefaultWriteParam());
                describe(metadata, hundredths, i == 0);
                writer.writeToSequence(new IIOImage(image, null, metadata), null);
            }
            writer.endWriteSequence();
        } finally {
            writer.dispose();
        }
    }

    private static void describe(IIOMetadata metadata, int hundredths, boolean first) throws IOException {
        IIOMetadataNode root = new IIOMetadataNode(FRAME_FORMAT);
        IIOMetadataNode control = new IIOMetadataNode("GraphicControlExtension");
        root.appendChild(control);
        control.setAttribute("disposalMethod", "doNotDispose");
        control.setAttribute("userInputFlag", "FALSE");
        control.setAttribute("transparentColorFlag", "FALSE");
        control.setAttribute("delayTime", Integer.toString(hundredths));
        control.setAttribute("transparentColorIndex", "0");
        if (first) {
            IIOMetadataNode loop = new IIOMetadataNode("ApplicationExtension");
            loop.setAttribute("applicationID", "NETSCAPE");
            loop.setAttribute("authenticationCode", "2.0");
            // Sub-block 1: number of repetitions, 16 bits; 0 means endless.
            loop.setUserObject(new byte[] {1, 0, 0});
            IIOMetadataNode extensions = new IIOMetadataNode("ApplicationExtensions");
            extensions.appendChild(loop);
            root.appendChild(extensions);
        }
        metadata.mergeTree(FRAME_FORMAT, root);
    }
}
