package nephele.engine.render.frame;

import nephele.engine.level.Sun;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.Uniforms;
import nephele.engine.scene.light.LampGrid;
import nephele.engine.scene.light.ShadowFrame;
import nephele.engine.scene.light.SkyIrradiance;

/** The values of {@code surface-light.glsl}, by name. */
final class LightUniforms {
    private LightUniforms() {}

    static void setSun(Uniforms uniforms, Sun sun) {
        var towards = sun.directionTowardsSun().toVector().normalize();
        uniforms.vector3("sunDirection").set((float) towards.x, (float) towards.y, (float) towards.z);
        set(uniforms.vector3("sunIrradiance"), sun.irradiance());
    }

    static void setAmbient(Uniforms uniforms, Vec3 radiance) {
        set(uniforms.vector3("ambientRadiance"), radiance);
    }

    static void setSunShadow(Uniforms uniforms, ShadowFrame frame) {
        uniforms.matrix4("sunMapFromAnchor").set(frame.mapFromAnchor().get(new float[16]));
        float texelDepth = (float) (frame.texelMetres() / frame.depthMetres());
        Vec3 right = frame.right();
        Vec3 up = frame.up();
        uniforms.vector4("sunMapRight").set((float) right.x(), (float) right.y(), (float) right.z(), texelDepth);
        uniforms.vector4("sunMapUp").set((float) up.x(), (float) up.y(), (float) up.z(), texelDepth / 2);
    }

    /** @param anchor what positions in shaders are relative to */
    static void setLampGrid(Uniforms uniforms, LampGrid grid, Vec3 anchor) {
        Vec3 cell = grid.cellMetres();
        set(uniforms.vector3("lampGridMin"), Directions.between(anchor, grid.min()));
        set(uniforms.vector3("lampGridCellsPerMetre"), new Vec3(1 / cell.x(), 1 / cell.y(), 1 / cell.z()));
        set(uniforms.vector3("lampGridSize"), new Vec3(grid.columns(), grid.floors(), grid.rows()));
    }

    static void setSky(Uniforms uniforms, SkyIrradiance sky) {
        double[] c = sky.coefficients();
        for (int i = 0; i < SkyIrradiance.TERMS; i++) {
            set(uniforms.vector3("skyCoefficients[" + i + "]"), new Vec3(c[3 * i], c[3 * i + 1], c[3 * i + 2]));
        }
    }

    private static void set(Uniforms.Vector3 uniform, Vec3 v) {
        uniform.set((float) v.x(), (float) v.y(), (float) v.z());
    }
}
