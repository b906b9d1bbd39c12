package sunbeam.precompute.scan.format;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

/** {@link TestField} as instruments write it. */
final class TestInstruments {
    private static final int COLUMNS = TestField.COLUMNS;
    private static final int ROWS = TestField.ROWS;
    private static final int COUNT = COLUMNS * ROWS;

    private TestInstruments() {}

    /**
     * Two images: the height's voltage, then a sensor's height, as trace. A step is 1 nm: 16 bits are 65.536 V at 1000 nm/V.
     *
     * @param bytes of a sample
     * @param said bytes that the header claims: of the steps that the scale is about
     */
    static byte[] nanoscope(int bytes, int said) {
        int header = 4096;
        int length = bytes * COUNT;
        double volts = 1e-3 * Math.pow(256, said);
        TestBytes file = TestBytes.little()
                .text(
                        "\\*File list\r\n\\Version: 0x09200000\r\n\\Data length: 4096\r\n\\*Scanner list\r\n\\@Sens. Zsens: V 10.00000 nm/V\r\n")
                .text("\\*Ciao scan list\r\n\\Scan Size: 3500 nm\r\n\\@Sens. ZsensSens: V 1000.000 nm/V\r\n");
        String image = """
                \\*Ciao image list
                \\Data offset: %d
                \\Data length: %d
                \\Bytes/pixel: %d
                \\Samps/line: 7
                \\Number of lines: 5
                \\Scan Size: 3.5 2 ~m
                \\Line Direction: Trace
                \\@2:Image Data: S [%s] "%s"
                \\@2:Z scale: V [Sens. %s] (0.006 V/LSB) %s V
                """.replace("\n", "\r\n");
        file.text(image.formatted(header, length, said, "Height", "Height", "Zsens", volts))
                .text(image.formatted(header + length, length, said, "ZSensor", "Height Sensor", "ZsensSens", volts))
                .text("\\*File list end\r\n\u001a")
                .zerosUpTo(header + length);
        TestField.upwards(nanometers -> {
            if (bytes == Short.BYTES) {
                file.int16(nanometers);
            } else {
                file.int32(nanometers);
            }
        });
        return file.array();
    }

    /** Two layers: height and phase. */
    static byte[] igorWave() {
        TestBytes file = TestBytes.little()
                .int16(5)
                .int16(0)
                .int32(320 + 4 * 2 * COUNT)
                .zeros(4 + 4 + 4 + 16 + 8)
                .int32(3 * 32)
                .zeros(4 + 12)
                .zerosUpTo(64 + 12)
                .int32(2 * COUNT)
                .int16(2)
                .zerosUpTo(64 + 68)
                .int32(COLUMNS)
                .int32(ROWS)
                .int32(2)
                .int32(0)
                .float64(TestField.WIDTH / COLUMNS)
                .float64(TestField.HEIGHT / ROWS)
                .zerosUpTo(64 + 148)
                .text("m", 4, '\0')
                .text("m", 4, '\0')
                .text("m", 4, '\0')
                .zerosUpTo(64 + 320);
        TestField.upwards(nanometers -> file.float32(1e-9 * nanometers));
        TestField.upwards(nanometers -> file.float32(0.1 * nanometers));
        file.zeros(32).text("HeightTrace", 32, '\0').text("PhaseTrace", 32, '\0');
        byte[] bytes = file.array();
        int sum = 0;
        for (int i = 0; i < 384; i += 2) {
            sum += (bytes[i] & 0xff) | (bytes[i + 1] << 8);
        }
        bytes[2] = (byte) -sum;
        bytes[3] = (byte) (-sum >> 8);
        return bytes;
    }

    /** A deflection, then the height forward; 2^16 steps of 1 nm, centered on zero. */
    static byte[] nanosurf() {
        String channel = """
                [DataSet-0:%d]
                Points=7
                Lines=5
                Frame=Scan forward
                Dim0Unit=m
                Dim0Range=3.5e-06
                Dim0Min=0
                Dim1Unit=m
                Dim1Range=2e-06
                Dim1Min=0
                Dim2Name=%s
                Dim2Unit=%s
                Dim2Range=6.5536e-05
                Dim2Min=-3.2768e-05
                SaveMode=Binary
                SaveBits=16
                SaveSign=Signed
                SaveOrder=Intel
                """.replace("\n", "\r\n");
        TestBytes file = TestBytes.little()
                .text("[DataSet]\r\nVersion=2\r\nGroupCount=1\r\nGr0-Name=Scan forward\r\nGr0-Count=2\r\n")
                .text("Gr0-Ch0=DataSet-0:0\r\nGr0-Ch1=DataSet-0:1\r\n")
                .text(channel.formatted(0, "Deflection", "N"))
                .text(channel.formatted(1, "Z-Axis", "m"))
                .text("#!")
                .zeros(2 * COUNT);
        TestField.upwards(file::int16);
        return file.array();
    }

    /** Doubles whose range is the amplitude; from the bottom right. */
    static byte[] wsxm(String type) {
        String header = "WSxM file copyright UAM\r\nSxM Image file\r\nImage header size: 400\r\n\r\n[Control]\r\n\r\n"
                + "    X Amplitude: 3.5 \u00b5m\r\n    Y Amplitude: 2000 nm\r\n\r\n[General Info]\r\n\r\n"
                + "    Acquisition channel: Topography\r\n    Image Data Type: " + type
                + "\r\n    Number of columns: 7\r\n    Number of rows: 5\r\n    Z Amplitude: 436 nm\r\n";
        TestBytes file = TestBytes.little().text(header, 384, ' ').text("\r\n[Header end]\r\n");
        for (int row = ROWS - 1; row >= 0; row--) {
            for (int column = COLUMNS - 1; column >= 0; column--) {
                int nanometers = TestField.nanometers(column, row);
                if (type.equals("short")) {
                    file.int16(nanometers);
                } else {
                    file.float64(nanometers);
                }
            }
        }
        return file.array();
    }

    /**
     * A thumbnail with the grid, then the height's retrace and trace with a raw slot and a default one.
     *
     * @param named whether the thumbnail has a channel's name; in .jpk-qi-image it has none
     */
    static byte[] jpk(boolean named) {
        TestTiff tiff = new TestTiff(TestBytes.big());
        TestTiff.Page thumbnail = tiff.page()
                .number(256, 4, 1)
                .number(257, 4, 1)
                .number(262, 3, 1)
                .number(0x8042, TestField.WIDTH)
                .number(0x8043, TestField.HEIGHT);
        if (named) {
            thumbnail.text(0x8050, "thumbnail");
        }
        for (int retrace = 1; retrace >= 0; retrace--) {
            TestBytes samples = TestBytes.big();
            boolean backward = retrace == 1;
            TestField.upwards(nanometers -> samples.int32(backward ? -nanometers : nanometers));
            tiff.page()
                    .number(256, 4, COLUMNS)
                    .number(257, 4, ROWS)
                    .number(258, 3, 32)
                    .number(259, 3, 1)
                    .number(262, 3, 1)
                    .data(273, 279, samples.array())
                    .number(339, 3, 2)
                    .text(0x8050, "measuredHeight")
                    .number(0x8051, 3, retrace)
                    .text(0x8052, "Height (measured)")
                    .number(0x8080, 4, 2)
                    .text(0x8081, "nominal")
                    .text(0x8090, "raw")
                    .text(0x80a3, "NullScaling")
                    .text(0x80c0, "nominal")
                    .text(0x80d2, "m")
                    .text(0x80d3, "LinearScaling")
                    .number(0x80d4, 1e-9)
                    .number(0x80d5, 0);
        }
        return tiff.array();
    }

    /** Floats of half a micrometer, with a gain of 2. */
    static byte[] park() {
        TestBytes header = TestBytes.little().int32(0).utf16("Z Height", 32).zerosUpTo(100);
        header.int32(COLUMNS).int32(ROWS).zerosUpTo(128).int32(1).zerosUpTo(140);
        header.float64(1e6 * TestField.WIDTH).float64(1e6 * TestField.HEIGHT).zerosUpTo(220);
        header.float64(2)
                .float64(1)
                .float64(0)
                .utf16("um", 8)
                .zerosUpTo(348)
                .int32(2)
                .zerosUpTo(580);
        TestBytes samples = TestBytes.little();
        TestField.upwards(nanometers -> samples.float32(0.5e-3 * nanometers));
        TestTiff tiff = new TestTiff(TestBytes.little());
        tiff.page()
                .number(256, 4, 1)
                .number(257, 4, 1)
                .number(50432, 4, 0x0e031301)
                .number(50433, 4, 0x01000002)
                .bytes(50434, samples.array())
                .bytes(50435, header.array());
        return tiff.array();
    }

    static byte[] surfaceData(boolean binary) {
        if (binary) {
            TestBytes file =
                    TestBytes.little().text("bISO-1.0", 42, ' ').int16(COLUMNS).int16(ROWS);
            file.float64(TestField.WIDTH / COLUMNS).float64(TestField.HEIGHT / ROWS);
            file.float64(1e-9).float64(-1).int8(0).int8(5).int8(0);
            TestField.downwards(file::int16);
            return file.array();
        }
        StringBuilder text = new StringBuilder("aISO-1.0\r\nManufacID = X\r\nNumPoints = 7\r\nNumProfiles = 5\r\n");
        text.append("Xscale = 5.0E-7\r\nYscale = 4.0E-7\r\nZscale = 1.0E-9\r\nZresolution = 1E-9\r\n");
        text.append("Compression = 0\r\nDataType = 5\r\nCheckType = 0\r\n*\r\n");
        TestField.downwards(nanometers -> text.append(nanometers).append("\r\n"));
        return text.append("*\r\n").toString().getBytes(StandardCharsets.US_ASCII);
    }

    /** 32-bit integers in steps of a nanometer. */
    static byte[] x3p() {
        String xml =
                "<?xml version=\"1.0\"?><p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\"><Record1><FeatureType>SUR</FeatureType><Axes>"
                        + "<CX><AxisType>I</AxisType><DataType>L</DataType><Increment>5e-7</Increment><Offset>0</Offset></CX>"
                        + "<CY><AxisType>I</AxisType><DataType>L</DataType><Increment>4e-7</Increment><Offset>0</Offset></CY>"
                        + "<CZ><AxisType>A</AxisType><DataType>L</DataType><Increment>1e-9</Increment></CZ></Axes></Record1>"
                        + "<Record3><MatrixDimension><SizeX>7</SizeX><SizeY>5</SizeY><SizeZ>1</SizeZ></MatrixDimension><DataLink>"
                        + "<PointDataLink>bindata/data.bin</PointDataLink></DataLink></Record3></p:ISO5436_2>";
        TestBytes samples = TestBytes.little();
        TestField.downwards(samples::int32);
        return zip(xml, samples.array());
    }

    static byte[] zip(String xml, byte[] samples) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
            zip.putNextEntry(new ZipEntry("bindata/data.bin"));
            zip.write(samples);
            zip.putNextEntry(new ZipEntry("main.xml"));
            zip.write(xml.getBytes(StandardCharsets.UTF_8));
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
        return bytes.toByteArray();
    }

    /** 16-bit integers in steps of a nanometer, after a comment. */
    static byte[] digitalSurf() {
        TestBytes file = TestBytes.little()
                .text("DIGITAL SURF")
                .int16(0)
                .int16(1)
                .int16(1)
                .int16(2);
        file.text("", 60, ' ').int16(0).int16(0).int16(0).int16(1).int16(0).zerosUpTo(98);
        file.int16(16).int32(-150).int32(286).int32(COLUMNS).int32(ROWS).int32(COUNT);
        file.float32(0.5).float32(0.4).float32(1e-3);
        file.text("X", 16, ' ').text("Y", 16, ' ').text("Z", 16, ' ');
        for (int i = 0; i < 6; i++) {
            file.text("\u00b5m", 16, ' ');
        }
        file.float32(1)
                .float32(1)
                .float32(1)
                .zerosUpTo(334)
                .int16(10)
                .zerosUpTo(512)
                .text("a comment.");
        TestField.downwards(file::int16);
        return file.array();
    }

    /** The sensor's friction, then the height: 2^15 steps are 32.768 um. */
    static byte[] agilent() {
        TestBytes file = TestBytes.little().text("fileType      Image\nxPixels       7\nyPixels       5\n");
        file.text(
                "xLength       3.5e-006\nyLength       2e-006\nbufferLabel   Friction\nbufferRange   10\nbufferUnit    V\n");
        file.text("bufferLabel   Topography\ndirection     Trace\nbufferRange   32.768\nbufferUnit    um\n");
        file.text("data          BINARY\n").zeros(2 * COUNT);
        TestField.upwards(file::int16);
        return file.array();
    }
}
