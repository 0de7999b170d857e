package nephele.engine.render.pass.cloud.volume;

import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.CloudSource;
import nephele.engine.cloud.field.NoiseField;
import nephele.engine.cloud.field.ProfiledNoise;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Quality.CloudScattering;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.shader.Uniforms.IfRead;
import nephele.engine.render.gl.shader.Uniforms.Vector4;
import nephele.engine.render.pass.cloud.CloudCanvas;
import nephele.engine.render.pass.cloud.CloudContext;
import nephele.engine.render.pass.cloud.CloudDrawing;
import nephele.engine.render.pass.cloud.CloudPrograms;
import nephele.engine.render.pass.cloud.CloudUniforms;
import nephele.engine.render.pass.cloud.LitCloud;
import nephele.engine.render.pass.cloud.PlacedCloud;
import nephele.engine.scene.View;

/** Marches rays through the cells of a cloud. */
public final class VolumeTechnique implements CloudDrawing {
    public static final Technique REGISTERED =
            new Technique(CloudTechnique.VOLUME, cloud -> true, VolumeTechnique::new);

    private final PlacedCloud placed;
    private final CloudSource cloud;
    private final LitCloud lit;
    private final CloudPrograms<MarchUniforms> programs;
    private final FullScreenTriangle triangle;
    private final double stepCells;
    /** {@code null} if the density comes from cells. */
    private final NoiseTextures noiseTextures;

    /** Its noise at the time; {@code null} if the density comes from cells. */
    private NoiseField noise;

    private record MarchUniforms(
            CloudUniforms cloud, @IfRead NoiseTextures.Places noise, Vector4 cellEdges, Vector4 stepping) {}

    private VolumeTechnique(CloudContext context, PlacedCloud placed) {
        this.placed = placed;
        cloud = placed.source();
        lit = new LitCloud(context.load(), placed);
        triangle = context.load().own(new FullScreenTriangle(context.load().gl(), "volume"));
        stepCells = context.load().quality().cloudStep();
        boolean isOctaves = context.load().quality().cloudScattering() == CloudScattering.OCTAVES;
        programs = new CloudPrograms<>(
                context,
                "cloud.vert",
                "volume/volume.frag",
                defines -> defines.withIf(cloud.isProfiled(), "NOISE")
                        .withIf(cloud.isProfiled() && cloud.evolves(), "EVOLVING")
                        .withIf(isOctaves, "OCTAVES"),
                MarchUniforms.class);
        noiseTextures = cloud.isProfiled()
                ? new NoiseTextures(
                        context.load(), (ProfiledNoise) cloud.noise(0).density(), cloud.levels())
                : null;
    }

    @Override
    public void follow(Environment environment, CloudInterval now) {
        lit.follow(environment, now);
        if (noiseTextures != null) {
            noise = cloud.noise(cloud.evolves() ? now.seconds() : 0);
            noiseTextures.upload(lit.earlier().boxes(), lit.later().boxes());
        }
    }

    @Override
    public void draw(CloudCanvas canvas) {
        MarchUniforms uniforms = programs.use(canvas.pixels());
        View view = canvas.view();
        canvas.put(uniforms.cloud, placed);
        lit.put(uniforms.cloud, view, canvas.focus());
        if (noiseTextures != null) {
            noiseTextures.bind(uniforms.noise, noise, view.eye().minus(placed.drift()));
        }
        CellBox narrowest = lit.earlier().cells().narrowest();
        Vec3 edges = new Vec3(narrowest.sizeX(), narrowest.sizeY(), narrowest.sizeZ());
        uniforms.cellEdges.set(edges, narrowest.shortest());
        uniforms.stepping.set(stepCells, 0.5, view.eyeY(), canvas.pixels().isLook() ? lit.depthAround(view) : 0);
        triangle.draw();
    }
}
