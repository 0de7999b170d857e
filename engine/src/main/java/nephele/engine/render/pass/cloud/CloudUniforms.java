package nephele.engine.render.pass.cloud;

import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.shader.Uniforms.IfRead;
import nephele.engine.render.gl.shader.Uniforms.Scalar;
import nephele.engine.render.gl.shader.Uniforms.Vector2;
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.render.gl.shader.Uniforms.Vector4;

/**
 * The uniforms that programs of clouds share; each program reads some of them. {@link CloudCanvas} sets those of {@code
 * cloud-pixel.glsl}, where and what is drawn; {@link LitCloud} those of {@code cloud-light.glsl} and {@code cell-boxes.glsl},
 * the cloud and its light.
 *
 * @param ranges for {@link CloudPixels#MIXED}
 */
public record CloudUniforms(
        @IfRead Vector2 layerStep,
        @IfRead Vector3 marchedSquare,
        @IfRead Vector3 blown,
        @IfRead Scalar capturedPlane,
        @IfRead Scalar cloudShare,
        @IfRead Vector3 boltFromEye,
        @IfRead List<Vector4> flashLights,
        @IfRead Vector3 flashIntensity,
        @IfRead CloudRanges.Places ranges,
        @IfRead Boxes nested,
        @IfRead Vector4 medium,
        @IfRead Vector4 phase,
        @IfRead Vector3 cloudSun,
        @IfRead Vector4 diffuseAxis,
        @IfRead Vector3 irradiance,
        @IfRead Vector3 skyAbove,
        @IfRead Vector3 skyBelow) {
    /** Boxes that a cloud has at most; {@code MOST_BOXES} in shaders. */
    static final int MOST_BOXES = 6;

    /** The uniforms of {@code cell-boxes.glsl}: nested boxes of cells around a focus. */
    public record Boxes(List<Vector4> boxes, Vector4 cells, Vector3 cloudBase, Vector3 cloudHalf) {
        /** Sets the place of a box. @param eye in the space of the boxes */
        public void put(int level, Aabb box, Vec3 eye) {
            Vec3 middle = box.centre().minus(eye);
            boxes.get(level).set(middle.x(), middle.z(), 1 / (box.maxX() - box.minX()), 1 / (box.maxZ() - box.minZ()));
        }

        /**
         * Sets the heights of the boxes and how far the narrowest one serves.
         *
         * @param middle of what the boxes are around, relative to the eye
         * @param reachX distance from it, metres; {@code reachZ} likewise
         */
        public void put(Aabb narrowest, Vec3 eye, Vec3 middle, double reachX, double reachZ) {
            cloudBase.set(middle.x(), narrowest.minY() - eye.y(), middle.z());
            cloudHalf.set(reachX, narrowest.maxY() - narrowest.minY(), reachZ);
        }
    }
}
