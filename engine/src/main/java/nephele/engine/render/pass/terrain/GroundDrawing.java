package nephele.engine.render.pass.terrain;

import nephele.engine.level.placed.StaticShape;
import nephele.engine.math.heightfield.DetailView;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Quality.TerrainDetail;
import nephele.engine.render.frame.SurfaceLight;
import nephele.engine.render.frame.SurfaceVariant;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.SharedObjects.Same;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.MaterialBlocks;
import nephele.engine.render.resource.TerrainMesh;
import nephele.engine.render.resource.TerrainTiles;
import nephele.engine.scene.light.LightRequirements;

/** One terrain with its program, materials and sky visibility. */
final class GroundDrawing {
    private static final String FOLDER = "/nephele/engine/render/pass/terrain/";

    private final TerrainMesh mesh;
    /** {@code null} if all triangles are drawn. */
    private final TerrainTiles tiles;

    private final double errorPixels;
    private final GroundLook look;
    private final SurfaceLight light;
    private final MaterialBlocks materials;
    private final GlProgram<GroundUniforms> program;
    /** {@code null} if the sky does not shine. */
    private final GroundSky sky;

    /** {@code null} without pictures. */
    private final Texture colours;

    GroundDrawing(LoadContext context, StaticShape.HeightGrid grid, TerrainMesh mesh) {
        this.mesh = mesh;
        errorPixels = context.quality().terrainErrorPixels();
        tiles = context.quality().terrainDetail() == TerrainDetail.LOD
                ? context.share(
                        TerrainTiles.class,
                        new TilesOf(new Same(grid.field())),
                        () -> new TerrainTiles(context.gl(), grid.field()))
                : null;
        look = GroundLook.of(grid, context.scene().materials());
        light = context.shared().surfaceLight();
        materials = context.own(new MaterialBlocks(context.gl(), look.surfaces()));
        program = program(context);
        sky = LightRequirements.skyShines(context.scene().level())
                ? context.share(
                        GroundSky.class,
                        new SkyOf(new Same(grid.field())),
                        () -> new GroundSky(context.gl(), grid.field()))
                : null;
        colours = look.kind().isTextured()
                ? context.shared().colourPictures().get(look.kind().colourArray())
                : null;
    }

    private record SkyOf(Same field) {}

    private record TilesOf(Same field) {}

    private GlProgram<GroundUniforms> program(LoadContext context) {
        SurfaceVariant surface = SurfaceVariant.of(look.kind(), context.quality());
        var defines = surface.addTo(
                        light.addForDynamicObjects(Defines.of(context))
                                .withIf(tiles != null, "DETAIL")
                                .with("LAYERS", look.surfaces().size()),
                        materials.materialsPerBlock())
                .values();
        return new GlProgram<>(
                context.gl(),
                ShaderSource.load(FOLDER + "terrain.vert", defines),
                ShaderSource.load(FOLDER + "terrain.frag", defines),
                uniforms -> uniforms(context, surface, uniforms));
    }

    private GroundUniforms uniforms(LoadContext context, SurfaceVariant surface, Uniforms uniforms) {
        surface.set(uniforms);
        light.tieForDynamicObjects(uniforms);
        uniforms.samplerIfRead("terrainSlopes", TextureUnit.TERRAIN_SLOPES);
        if (tiles != null) {
            uniforms.sampler("terrainTiles", TextureUnit.TERRAIN_TILES);
        }
        if (LightRequirements.skyShines(context.scene().level())) {
            uniforms.sampler("terrainSky", TextureUnit.SKY_VISIBILITY);
        }
        return GroundUniforms.of(
                uniforms,
                look.surfaces().size(),
                look.kind(),
                light,
                context.quality().terrainDetail());
    }

    void draw(FrameContext frame) {
        program.use();
        GroundUniforms uniforms = program.uniforms();
        uniforms.set(mesh.field(), look, light.anchor());
        uniforms.place()
                .set(
                        mesh.field(),
                        frame.view().eyeX(),
                        frame.view().eyeY(),
                        frame.view().eyeZ());
        materials.bind(0);
        mesh.bind();
        if (sky != null) {
            sky.bind();
        }
        if (colours != null) {
            colours.bind(TextureUnit.COLOURS);
        }
        if (tiles == null) {
            mesh.draw(frame.seen(), (column, row) -> uniforms.place().chunk(mesh.field(), column, row));
        } else {
            drawTiles(frame, uniforms);
        }
    }

    private void drawTiles(FrameContext frame, GroundUniforms uniforms) {
        DetailView view = TerrainTiles.seenFrom(frame.view());
        double scale = TerrainTiles.scale(
                frame.view().projection(),
                frame.surface().width(),
                frame.surface().height(),
                errorPixels);
        uniforms.place().chunk(mesh.field(), 0, 0);
        uniforms.setDetail(view);
        tiles.draw(view, scale, frame.seen());
    }
}
