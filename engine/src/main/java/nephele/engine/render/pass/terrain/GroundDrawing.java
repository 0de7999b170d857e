package nephele.engine.render.pass.terrain;

import java.nio.ByteBuffer;
import java.util.List;
import nephele.engine.asset.LayerMap;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.terrain.TerrainLayers;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.DetailView;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.LayerMixing;
import nephele.engine.render.frame.Quality.TerrainDetail;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.SharedObjects.Identity;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms.IfRead;
import nephele.engine.render.gl.shader.Uniforms.Vector2;
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.render.gl.shader.Uniforms.Vector4;
import nephele.engine.render.resource.MaterialBlocks;
import nephele.engine.render.resource.PictureArrays;
import nephele.engine.render.resource.SummedLight;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.render.resource.TerrainMesh;
import nephele.engine.render.resource.TerrainTiles;
import nephele.engine.render.resource.TerrainTiles.Slopes;
import nephele.engine.render.resource.TerrainUniforms;
import nephele.engine.scene.View;
import nephele.engine.scene.light.TerrainSky;
import org.lwjgl.system.MemoryUtil;

/** One terrain with its programs, materials, painted layers and sky visibility. */
final class GroundDrawing {
    private static final String FOLDER = "/nephele/engine/render/pass/terrain/";

    private final TerrainMesh mesh;
    /** {@code null} if all triangles are drawn. */
    private final TerrainTiles tiles;

    private final double errorPixels;
    private final boolean isBaked;
    private final GroundLook look;
    private final SurfaceLight light;
    private final MaterialBlocks materials;
    private final List<Part> parts;
    /** The sky visibility; {@code null} if no light needs it. */
    private final Texture sky;

    /** {@code null} if no light was baked. */
    private final Texture bakedLight;

    /** {@code null} without painted layers. */
    private final LayerMap paintedLayers;

    /** Its texels are fetched, not filtered, since indices have no mean. */
    private final Texture paint;

    /** {@code null} without pictures. */
    private final Texture colours;

    /** {@code null} without normal maps. */
    private final Texture normals;

    GroundDrawing(LoadContext context, StaticShape.HeightGrid grid, TerrainMesh mesh) {
        this.mesh = mesh;
        errorPixels = context.quality().terrainErrorPixels();
        tiles = context.quality().terrainDetail() == TerrainDetail.LOD
                ? context.share(
                        TerrainTiles.class,
                        new Identity(grid.field()),
                        () -> new TerrainTiles(context.gl(), grid.field()))
                : null;
        isBaked = context.quality().terrainLayers() == LayerMixing.BAKED;
        GroundLook authored = GroundLook.of(grid, context.scene().materials());
        look = isBaked ? authored.baked() : authored;
        light = context.get(SurfaceLight.RESOURCE);
        materials = context.own(new MaterialBlocks(context.gl(), look.surfaces()));
        paintedLayers = grid.painted().orElse(null);
        paint = paintedLayers == null ? null : paint(context, paintedLayers);
        parts = slopes(context.quality()).stream()
                .map(slopes -> new Part(slopes, program(context, slopes)))
                .toList();
        SummedLight summed = context.get(SummedLight.RESOURCE);
        bakedLight = summed == null ? null : summed.ground(grid);
        sky = light.groundReadsSky() ? sky(context, grid.field()) : null;
        colours = isBaked ? baked(context, grid) : look.kind().isTextured() ? colours(context, look.colours()) : null;
        normals =
                MaterialBlocks.readsNormalMap(look.kind(), context.quality()) ? normals(context, look.normals()) : null;
    }

    /** The uniforms of a terrain's program. The program reads what the terrain, its layers and its light require. */
    private record GroundUniforms(
            TerrainUniforms place,
            @IfRead Vector4 detailView,
            @IfRead Vector3 detailAlong,
            @IfRead Vector2 halfSteps,
            @IfRead Vector2 cellMetres,
            @IfRead Vector3 originFromAnchor,
            @IfRead Vector2 bakedPerMetre,
            @IfRead Vector2 texelsPerMetre,
            @IfRead List<Vector4> layerHeights,
            @IfRead List<Vector4> layerSlopes,
            @IfRead List<Vector3> layerOrigins) {
        /** Steps a pixel of the grid to which rasterisers round corners; OpenGL demands 16, all known ones have 256. */
        private static final float STEPS_PER_PIXEL = 256;

        void set(HeightField field, GroundLook look, Vec3 anchor) {
            cellMetres.set(field.cellX(), field.cellZ());
            originFromAnchor.set(field.origin().minus(anchor));
            bakedPerMetre.set(1 / (field.cellX() * field.cellColumns()), 1 / (field.cellZ() * field.cellRows()));
            double[] limits = look.limits();
            for (int i = 0; i < layerHeights.size(); i++) {
                set(layerHeights.get(i), limits, TerrainLayers.LIMITS * i);
                set(layerSlopes.get(i), limits, TerrainLayers.LIMITS * i + 4);
            }
            for (int i = 0; i < layerOrigins.size(); i++) {
                layerOrigins.get(i).set(look.origins().get(i));
            }
        }

        void setPaint(HeightField field, LayerMap map) {
            double columns = (map.columns() - 1) / (field.cellX() * field.cellColumns());
            double rows = (map.rows() - 1) / (field.cellZ() * field.cellRows());
            texelsPerMetre.set(columns, rows);
        }

        /**
         * Sets the view of a terrain of few triangles.
         *
         * @param width of its picture, pixels; {@code height} likewise
         */
        void setDetail(DetailView view, int width, int height) {
            halfSteps.set(STEPS_PER_PIXEL * width / 2, STEPS_PER_PIXEL * height / 2);
            detailView.set(view.forward(), view.leastShare());
            detailAlong.set(view.along());
        }

        private static void set(Vector4 uniform, double[] values, int at) {
            uniform.set(values[at], values[at + 1], values[at + 2], values[at + 3]);
        }
    }

    /** The tiles that a program draws. */
    private record Part(Slopes slopes, GlProgram<GroundUniforms> program) {}

    /** Pictures on tiles without steep slopes are read from above alone, by a program that costs less. */
    private List<Slopes> slopes(Quality quality) {
        boolean hasProjections =
                !isBaked && (look.kind().isTextured() || MaterialBlocks.readsNormalMap(look.kind(), quality));
        return tiles != null && hasProjections ? List.of(Slopes.GENTLE, Slopes.STEEP) : List.of(Slopes.ALL);
    }

    private static Texture paint(LoadContext context, LayerMap map) {
        return context.share(
                Texture.class,
                new Identity(map),
                () -> texture(
                        context.gl(),
                        "terrain layers",
                        PixelFormat.RG8,
                        Texture.Extent.flat(map.columns(), map.rows()),
                        Sampling.NEAREST_CLAMP,
                        map.texels()));
    }

    private static Texture sky(LoadContext context, HeightField field) {
        TerrainSky sky = context.shareValue(TerrainSky.class, new Identity(field), () -> {
            List<TerrainSky> known = context.gl().shared().all(TerrainSky.class);
            return TerrainMesh.mostSimilar(known, TerrainSky::field, field)
                    .map(similar -> TerrainSky.edited(similar, field))
                    .orElseGet(() -> TerrainSky.of(field));
        });
        return context.share(
                Texture.class,
                new Identity(sky),
                () -> texture(
                        context.gl(),
                        "terrain sky visibility",
                        PixelFormat.R8,
                        Texture.Extent.flat(sky.columns(), sky.rows()),
                        Sampling.LINEAR_CLAMP,
                        sky.values()));
    }

    private static Texture texture(
            GlContext gl, String name, PixelFormat format, Texture.Extent extent, Sampling sampling, byte[] values) {
        Texture texture = new Texture(gl, name, Texture.Shape.FLAT, format, extent, sampling);
        ByteBuffer texels = MemoryUtil.memAlloc(values.length);
        texture.upload(0, texels.put(values).flip());
        MemoryUtil.memFree(texels);
        return texture;
    }

    private GlProgram<GroundUniforms> program(LoadContext context, Slopes slopes) {
        var defines = materials
                .addTo(light.addForGround(Defines.of(context)), look.kind(), context.quality())
                .withIf(tiles != null, "DETAIL")
                .withIf(isBaked, "BAKED")
                .withIf(slopes == Slopes.GENTLE, "FROM_ABOVE")
                .withIf(paint != null, "PAINTED")
                .with("LAYERS", look.surfaces().size())
                .values();
        return GlProgram.of(
                context.gl(), FOLDER + "terrain.vert", FOLDER + "terrain.frag", defines, GroundUniforms.class);
    }

    private static Texture baked(LoadContext context, StaticShape.HeightGrid grid) {
        var mixture = BakedLayers.of(
                grid, context.scene().materials(), context.output().decoding());
        return PictureArrays.enlargedColours(context, List.of(mixture));
    }

    private static Texture colours(LoadContext context, LayerPictures pictures) {
        return pictures.array() == LayerPictures.OWN
                ? PictureArrays.enlargedColours(context, pictures.own())
                : context.get(PictureArrays.COLOURS).get(pictures.array());
    }

    private static Texture normals(LoadContext context, LayerPictures pictures) {
        return pictures.array() == LayerPictures.OWN
                ? PictureArrays.enlargedNormals(context, pictures.own())
                : context.get(PictureArrays.NORMALS).get(pictures.array());
    }

    void draw(FrameContext frame) {
        bind();
        if (tiles != null) {
            tiles.select(TerrainTiles.detailView(frame.view()), scale(frame), frame.frustum());
        }
        for (int i = 0; i < parts.size(); i++) {
            Part part = parts.get(i);
            part.program().use();
            GroundUniforms uniforms = part.program().uniforms();
            set(uniforms, frame);
            if (tiles != null) {
                tiles.draw(part.slopes());
            } else {
                mesh.draw(frame.frustum(), uniforms.place());
            }
        }
    }

    private void bind() {
        materials.bind(0);
        mesh.bind();
        if (sky != null) {
            sky.bind(TextureUnit.SKY_VISIBILITY);
        }
        if (bakedLight != null) {
            bakedLight.bind(TextureUnit.BAKED_LIGHT);
        }
        if (paint != null) {
            paint.bind(TextureUnit.TERRAIN_LAYERS);
        }
        if (colours != null) {
            colours.bind(TextureUnit.COLOURS);
        }
        if (normals != null) {
            normals.bind(TextureUnit.NORMALS);
        }
    }

    private void set(GroundUniforms uniforms, FrameContext frame) {
        View view = frame.view();
        uniforms.set(mesh.field(), look, light.anchor());
        uniforms.place().set(mesh.field(), view.eyeX(), view.eyeY(), view.eyeZ());
        if (paint != null) {
            uniforms.setPaint(mesh.field(), paintedLayers);
        }
        if (tiles != null) {
            uniforms.place().chunk(mesh.field(), 0, 0);
            uniforms.setDetail(
                    TerrainTiles.detailView(view),
                    frame.surface().width(),
                    frame.surface().height());
        }
    }

    private double scale(FrameContext frame) {
        return TerrainTiles.scale(
                frame.view().projection(),
                frame.surface().width(),
                frame.surface().height(),
                errorPixels);
    }
}
