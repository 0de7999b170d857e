package nephele.engine.render.pass.cloud;

import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.shader.Uniforms;

/** The uniforms of {@code cell-boxes.glsl}: nested boxes of cells around a focus. */
public record BoxUniforms(
        List<Uniforms.Vector4> boxes, Uniforms.Vector4 cells, Uniforms.Vector3 base, Uniforms.Vector3 half) {
    /** @param count {@code MOST_BOXES} of the program */
    public static BoxUniforms of(Uniforms uniforms, int count) {
        return new BoxUniforms(
                IntStream.range(0, count)
                        .mapToObj(i -> uniforms.vector4("boxes[" + i + "]"))
                        .toList(),
                uniforms.vector4("cells"),
                uniforms.vector3("cloudBase"),
                uniforms.vector3("cloudHalf"));
    }

    /** Sets the place of a box. @param eye in the space of the boxes */
    public void put(int level, Aabb box, Vec3 eye) {
        Vec3 middle = box.centre().minus(eye);
        boxes.get(level).set((float) middle.x(), (float) middle.z(), (float) (1 / (box.maxX() - box.minX())), (float)
                (1 / (box.maxZ() - box.minZ())));
    }

    /**
     * Sets the heights of the boxes and how far the narrowest one serves.
     *
     * @param middle of what the boxes are around, relative to the eye
     * @param reachX distance from it, metres; {@code reachZ} likewise
     */
    public void put(Aabb narrowest, Vec3 eye, Vec3 middle, double reachX, double reachZ) {
        base.set((float) middle.x(), (float) (narrowest.minY() - eye.y()), (float) middle.z());
        half.set((float) reachX, (float) (narrowest.maxY() - narrowest.minY()), (float) reachZ);
    }
}
