package nephele.engine.scene.light.bake;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.Optional;
import java.util.zip.CRC32;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.InflaterInputStream;
import nephele.engine.level.Brush;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;

/** The encoding of a baked sky visibility, and its file name, which depends on the geometry. */
public final class SkyVisibilityFile {
    /** Part of every name: raise it whenever the same solids would bake to other texels. */
    private static final int VERSION = 3;

    private static final byte[] MAGIC = "NSKYVIS2".getBytes(StandardCharsets.US_ASCII);

    private SkyVisibilityFile() {}

    /** The glob of the names that {@link #nameFor} returns. */
    static final String NAMES = "sky-visibility-*.bin";

    /** Returns the file name; it is the same for the same shapes in the same order, independent of materials. */
    public static String nameFor(StaticShapes statics) {
        MessageDigest digest = sha256();
        ByteBuffer buffer = ByteBuffer.allocate(4 * Double.BYTES);
        digest.update((byte) VERSION);
        digest.update(bytes(buffer, LightMapLayout.TEXEL_METRES, SkyVisibilityBake.RAYS, 0, 0));
        for (Brush brush : statics.solids()) {
            digest.update((byte) brush.shape().faces().size());
            for (ConvexPolyhedron.Face face : brush.shape().faces()) {
                Plane p = face.plane();
                digest.update(bytes(buffer, p.nx(), p.ny(), p.nz(), p.distance()));
            }
        }
        statics.models().all().forEach(model -> addMesh(model.triangles(), digest));
        statics.ground().forEach(grid -> addGround(grid.field(), digest));
        return "sky-visibility-" + HexFormat.of().formatHex(digest.digest(), 0, 10) + ".bin";
    }

    private static void addMesh(WorldTriangles mesh, MessageDigest digest) {
        ByteBuffer bytes = ByteBuffer.allocate(
                Integer.BYTES * (1 + mesh.vertices().length) + 2 * Double.BYTES * mesh.positions().length);
        bytes.putInt(mesh.vertices().length);
        for (int vertex : mesh.vertices()) {
            bytes.putInt(vertex);
        }
        for (int i = 0; i < mesh.positions().length; i++) {
            bytes.putDouble(mesh.positions()[i] + 0.0).putDouble(mesh.normals()[i] + 0.0);
        }
        digest.update(bytes.array());
    }

    private static void addGround(HeightField field, MessageDigest digest) {
        Vec3 origin = field.origin();
        ByteBuffer place = ByteBuffer.allocate(4 * Double.BYTES);
        digest.update(bytes(place, origin.x(), origin.y(), origin.z(), field.cellX()));
        digest.update(bytes(place, field.cellZ(), field.cellColumns(), field.cellRows(), 0));
        ByteBuffer heights = ByteBuffer.allocate(Float.BYTES * (field.cellColumns() + 1));
        for (int row = 0; row <= field.cellRows(); row++) {
            heights.clear();
            for (int column = 0; column <= field.cellColumns(); column++) {
                heights.putFloat(field.height(column, row) + 0.0f);
            }
            digest.update(heights.array());
        }
    }

    private static byte[] bytes(ByteBuffer buffer, double a, double b, double c, double d) {
        buffer.clear();
        // Adding zero makes −0 and 0 the same geometry.
        buffer.putDouble(a + 0.0).putDouble(b + 0.0).putDouble(c + 0.0).putDouble(d + 0.0);
        return buffer.array();
    }

    static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }

    /** Encodes the values as differences between consecutive values, deflated: smooth light shrinks to a quarter. */
    public static byte[] encode(SkyVisibility visibility) {
        LightMapLayout layout = visibility.layout();
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream head = new DataOutputStream(bytes)) {
            head.write(MAGIC);
            head.writeInt(layout.width());
            head.writeInt(layout.height());
            head.writeLong(placement(layout));
            try (DataOutputStream body = new DataOutputStream(new DeflaterOutputStream(bytes))) {
                write(visibility.texels(), body);
                write(visibility.ofModels(), body);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    /** Writes values as differences between consecutive ones. */
    static void write(short[] values, DataOutputStream body) throws IOException {
        short previous = 0;
        for (short value : values) {
            body.writeShort(value - previous);
            previous = value;
        }
    }

    /** Returns a checksum of all charts' positions: a map of the same size may be packed in another order. */
    static long placement(LightMapLayout layout) {
        CRC32 crc = new CRC32();
        ByteBuffer place = ByteBuffer.allocate(4 * Integer.BYTES);
        for (int i = 0; i < layout.charts().size(); i++) {
            LightMapChart chart = layout.charts().get(i);
            place.clear();
            place.putInt(layout.columnOf()[i]).putInt(layout.rowOf()[i]);
            place.putInt(chart.columns()).putInt(chart.rows());
            crc.update(place.array());
        }
        return crc.getValue();
    }

    /**
     * Decodes a file; empty if the bytes are no visibility for this layout, which is then baked again.
     *
     * @param statics the baked static geometry
     */
    public static Optional<SkyVisibility> decode(LightMapLayout layout, StaticShapes statics, byte[] bytes) {
        try (DataInputStream head = new DataInputStream(new ByteArrayInputStream(bytes))) {
            byte[] magic = head.readNBytes(MAGIC.length);
            boolean fits = MessageDigest.isEqual(magic, MAGIC)
                    && head.readInt() == layout.width()
                    && head.readInt() == layout.height()
                    && head.readLong() == placement(layout);
            if (!fits) {
                return Optional.empty();
            }
            InflaterInputStream body = new InflaterInputStream(head);
            short[] texels = values(body, layout.width() * layout.height());
            short[] ofModels = values(body, statics.models().vertexCount());
            return Optional.of(new SkyVisibility(layout, statics, texels, ofModels));
        } catch (IOException e) {
            return Optional.empty();
        }
    }

    /** Reads what {@link #write} wrote. */
    static short[] values(InputStream body, int count) throws IOException {
        byte[] packed = body.readNBytes(2 * count);
        if (packed.length != 2 * count) {
            throw new IOException("too short");
        }
        ByteBuffer differences = ByteBuffer.wrap(packed);
        short[] values = new short[count];
        short previous = 0;
        for (int i = 0; i < count; i++) {
            previous += differences.getShort();
            values[i] = previous;
        }
        return values;
    }
}
