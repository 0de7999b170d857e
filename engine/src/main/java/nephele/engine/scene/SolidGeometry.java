package nephele.engine.scene;

import java.nio.ByteBuffer;
import java.nio.IntBuffer;
import java.util.List;
import nephele.engine.level.Solid;
import nephele.engine.math.SpatialIndex;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.LightMapLayout;

/**
 * All solids as one static mesh: what never moves is drawn from one vertex and one index buffer.
 *
 * <p>A vertex takes {@link #VERTEX_BYTES}: position, three floats relative to its batch's cell origin; outward normal,
 * three 16-bit integers to be normalised, and with them the material's index within its block; texture coordinates,
 * two floats. With sky visibility {@link #LIGHT_MAP_BYTES} more: light map coordinates as two 16-bit integers in
 * sixteenths of a texel.
 */
public final class SolidGeometry {
    public static final int VERTEX_BYTES = 28;

    public static final int LIGHT_MAP_BYTES = 4;

    /** Materials per uniform block: 16 KiB, which every OpenGL allows, at 64 bytes a material. */
    public static final int MATERIALS_PER_BLOCK = 256;

    private final ByteBuffer vertices;
    private final IntBuffer indices;
    private final List<SolidBatch> batches;
    private final SpatialIndex index;
    private final Vec3 origin;
    private final boolean lightMapped;

    SolidGeometry(
            ByteBuffer vertices,
            IntBuffer indices,
            List<SolidBatch> batches,
            SpatialIndex index,
            Vec3 origin,
            boolean lightMapped) {
        this.vertices = vertices;
        this.indices = indices;
        this.batches = List.copyOf(batches);
        this.index = index;
        this.origin = origin;
        this.lightMapped = lightMapped;
    }

    /** @param lightMap how faces are cut and lie in the light map, or {@code null} for none */
    public static SolidGeometry of(List<Solid> solids, SceneMaterials materials, LightMapLayout lightMap) {
        return new SolidMesher(solids, materials, lightMap).mesh();
    }

    /** Middle of all solids, which every cell's origin is a whole number of cells away from. */
    public Vec3 origin() {
        return origin;
    }

    /** Whether vertices carry light map coordinates. */
    public boolean lightMapped() {
        return lightMapped;
    }

    public boolean isEmpty() {
        return batches.isEmpty();
    }

    /** Direct, native byte order. */
    public ByteBuffer vertices() {
        return vertices;
    }

    /** Direct; triangles counter-clockwise seen from outside. */
    public IntBuffer indices() {
        return indices;
    }

    public List<SolidBatch> batches() {
        return batches;
    }

    /** Slots of the index, one for each solid; no batch can be cut into more ranges. */
    public int slotCount() {
        return index.size();
    }

    SpatialIndex index() {
        return index;
    }
}
