package nephele.engine.render.resource;

import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.render.gl.shader.Uniforms.Vector4;
import nephele.engine.render.gl.shader.Uniforms.WholeVector4;

/**
 * The uniforms of {@code terrain-position.glsl}. A place is the difference of two sums of two floats, so that it is exact
 * near the eye and the same in all chunks: the higher float of a cell's length has few enough bits for its products with
 * column numbers to be exact.
 */
public record TerrainUniforms(WholeVector4 chunk, Vector4 cellHighLow, EyeUniforms eye) {
    /** Bits of a float that are zero in the higher part of a cell's length: columns have up to 14 bits. */
    private static final int FREE_BITS = 14;

    /** Sets the field and the eye, in world metres. */
    public void set(HeightField field, double eyeX, double eyeY, double eyeZ) {
        float highX = high(field.cellX());
        float highZ = high(field.cellZ());
        cellHighLow.set(highX, highZ, (float) (field.cellX() - highX), (float) (field.cellZ() - highZ));
        Vec3 origin = field.origin();
        eye.set(eyeX - origin.x(), eyeY - origin.y(), eyeZ - origin.z());
    }

    /** Sets the chunk that is drawn next. */
    public void chunk(HeightField field, int column, int row) {
        chunk.set(column, row, field.cellColumns(), field.cellRows());
    }

    static float high(double metres) {
        return Float.intBitsToFloat(Float.floatToIntBits((float) metres) & -1 << FREE_BITS);
    }
}
