package nephele.engine.render.frame;

import java.util.function.Consumer;
import nephele.engine.cloud.drawn.SkyplaneShape;
import nephele.engine.cloud.light.BallLight;
import nephele.engine.cloud.octave.ProceduralNoise;

/**
 * Settings that trade accuracy for speed.
 *
 * @param pictureResolution pixels that are drawn along each side, as a share of the picture's; fewer are scaled up
 * @param upscale filter that scales the picture up; without effect at resolution 1
 * @param anisotropy greatest number of texture samples along the steepest direction
 * @param normalMaps whether normal maps change the light on surfaces
 * @param brdf reflection of punctual, sun and ambient light
 * @param shadowTexels greatest length of the longer side of the sun's shadow map
 * @param shadowFilter texels of depth maps that decide the light of a point
 * @param lightShadows greatest number of punctual lights that cast shadows, the most powerful ones
 * @param samples greatest number of coverage samples a pixel; 1 draws without multisampling
 * @param edgeFilter filter of the displayed picture that smooths edges
 * @param cloudResolution rays through clouds along each side, as a share of the drawn pixels
 * @param cloudHistory frames among which the rays of the main view through clouds are divided
 * @param cloudStep length of a step through a cloud, in its cells
 * @param cloudLightCell edge of a cell of the light in clouds, in their cells of density
 * @param cloudScattering model of light that clouds scatter more than once
 * @param particleLight model of sunlight in clouds of technique {@code particles}
 * @param impostors whether clouds of balls that are far away are drawn from pictures of them
 * @param impostorErrorPixels greatest distance at which such a picture has a part of a cloud in a wrong place
 * @param skyplaneShape shape of the sheets of technique {@code skyplane}
 * @param proceduralNoise noise of technique {@code procedural}
 * @param cloudSkyboxTexels texels along a face of 90° of a cloud of technique {@code skybox}
 * @param terrainDetail triangles of which terrains are drawn
 * @param terrainErrorPixels greatest distance, in drawn pixels, at which coarser triangles show a point of a terrain
 * @param terrainLayers where the layers of terrains are mixed
 * @param spriteCoverage what smaller mipmap levels of billboards with edges keep
 * @param lightParts the light of surfaces that is shown
 * @param impostorPixels size of a model, in drawn pixels, below which its impostor is drawn; 0 always draws meshes
 * @param portalTechnique technique of drawing a view through an opening
 * @param viewBudget greatest number of views through openings in a frame; the largest ones are drawn
 * @param portalResolution pixels of an opening's own picture along each side, as a share of the picture's; for TEXTURE
 */
public record Quality(
        double pictureResolution,
        Upscale upscale,
        int anisotropy,
        NormalMaps normalMaps,
        ReflectionModel brdf,
        int shadowTexels,
        ShadowSampling shadowFilter,
        int lightShadows,
        int samples,
        EdgeFilter edgeFilter,
        double cloudResolution,
        CloudHistory cloudHistory,
        double cloudStep,
        int cloudLightCell,
        CloudScattering cloudScattering,
        BillboardFacing billboardFacing,
        BallLight particleLight,
        ImpostorChoice impostors,
        double impostorErrorPixels,
        SkyplaneShape skyplaneShape,
        ProceduralNoise proceduralNoise,
        int cloudSkyboxTexels,
        TerrainDetail terrainDetail,
        double terrainErrorPixels,
        LayerMixing terrainLayers,
        SpriteCoverage spriteCoverage,
        LightParts lightParts,
        double impostorPixels,
        PortalTechnique portalTechnique,
        int viewBudget,
        double portalResolution) {
    /** Enough for every light that can have a shadow. */
    public static final int ALL_LIGHTS = 999;

    public static final Quality HIGH = new Quality(
            1,
            Upscale.SHARP_BILINEAR,
            1,
            NormalMaps.ON,
            ReflectionModel.GGX,
            4096,
            ShadowSampling.BILINEAR,
            ALL_LIGHTS,
            1,
            EdgeFilter.NONE,
            0.5,
            CloudHistory.FOUR_FRAMES,
            1,
            2,
            CloudScattering.TWO_STREAM,
            BillboardFacing.VIEWER,
            BallLight.TAIL,
            ImpostorChoice.AUTO,
            1,
            SkyplaneShape.SHELL,
            ProceduralNoise.SMOOTH,
            512,
            TerrainDetail.LOD,
            1,
            LayerMixing.MIXED,
            SpriteCoverage.KEPT,
            LightParts.ALL,
            64,
            PortalTechnique.STENCIL,
            12,
            1);
    public static final Quality LOW = HIGH.withPictureResolution(0.5)
            .withShadowTexels(2048)
            .withCloudHistory(CloudHistory.SIXTEEN_FRAMES)
            .withCloudStep(2)
            .withViewBudget(6);
    public static final Quality MEDIUM = HIGH.withPictureResolution(0.7).withViewBudget(9);
    public static final Quality ULTRA = HIGH.withAnisotropy(8)
            .withSamples(4)
            .withCloudResolution(1)
            .withCloudHistory(CloudHistory.NONE)
            .withImpostors(ImpostorChoice.OFF)
            .withViewBudget(32);

    /** The filter that smooths edges of the displayed picture. */
    public enum EdgeFilter {
        NONE,
        /** Morphological antialiasing: coverage is estimated from the shapes of edges. */
        MORPHOLOGICAL
    }

    /** How many frames share the rays of a view through clouds; a ray that was not marched now shows an earlier frame. */
    public enum CloudHistory {
        NONE(1),
        FOUR_FRAMES(2),
        SIXTEEN_FRAMES(4);

        private final int side;

        CloudHistory(int side) {
            this.side = side;
        }

        /** Returns the side of the square of rays of which a frame marches one. */
        public int side() {
            return side;
        }
    }

    /** The model of light that clouds scatter more than once. */
    public enum CloudScattering {
        /** {@link nephele.engine.cloud.light.CloudLight}: two streams of diffuse light, small angles along the path. */
        TWO_STREAM,
        /**
         * Eight times single scattering, each with half the light, optical depth and asymmetry of the one before
         * (Wrenninge 2013); the sum is far too dark in thick clouds.
         */
        OCTAVES
    }

    /** How the flat pictures of clouds of technique billboard are turned; shaders know the order. */
    public enum BillboardFacing {
        /** As the screen. */
        SCREEN,
        /** Towards the eye. */
        VIEWER,
        /** Towards the eye about an upright axis. */
        AXIAL,
        /** By the formula of a source of 2004, which is wrong beside the axes and undefined on them. */
        SOURCE
    }

    /** Decides which clouds of balls are drawn from pictures of them. */
    public enum ImpostorChoice {
        OFF,
        /** Impostors for balls whose pictures stay valid long enough to repay drawing them. */
        AUTO
    }

    /** The triangles of which terrains are drawn. */
    public enum TerrainDetail {
        /** All of the height map. */
        FULL,
        /** {@link nephele.engine.math.heightfield.DetailRanges}: fewer where the picture shows no difference. */
        LOD
    }

    /** Where the layers of a terrain are mixed. */
    public enum LayerMixing {
        /** At each pixel, in the pictures' own resolution, with normal maps. */
        MIXED,
        /** Once, seen from above, into one picture for the whole terrain, as in a source of 2010. */
        BAKED
    }

    /** What smaller mipmap levels of billboards with edges keep. */
    public enum SpriteCoverage {
        /** The share of the picture that is drawn, see {@link nephele.engine.level.billboard.AlphaCoverage}. */
        KEPT,
        /** The mean of alpha: crowns become thin far away. */
        MEAN
    }

    /** The parts of the light that surfaces reflect; what glows shows always. */
    public enum LightParts {
        ALL,
        /** Light of the sky, or the ambient constant of the level. */
        AMBIENT,
        /** Light of sun, lamps and lightning that is reflected diffusely. */
        DIFFUSE,
        /** Light of sun, lamps and lightning that the specular lobe reflects. */
        SPECULAR
    }

    /** The filter that scales a picture up. */
    public enum Upscale {
        /** The four nearest pixels by their distances. */
        BILINEAR,
        /** The four nearest pixels with steeper weights: as cheap, and nearer to the whole picture. */
        SHARP_BILINEAR,
        /** Twelve pixels, weighted along the edges between them. */
        EDGE_ADAPTIVE
    }

    /** Decides whether normal maps are read. */
    public enum NormalMaps {
        ON,
        OFF
    }

    /** The reflection of light by a surface. */
    public enum ReflectionModel {
        /** All light is reflected diffusely, also by metal; nothing shines. */
        LAMBERT,
        /** {@link nephele.engine.level.appearance.Brdf}. */
        GGX
    }

    /** The texels of a shadow map that decide the light of a point. */
    public enum ShadowSampling {
        /** The one that contains it: edges with steps. */
        NEAREST,
        /** The four around it, weighted. */
        BILINEAR
    }

    /**
     * Returns the preset as a graphics card draws it, where samples, anisotropy and filters cost little: 2, 4, 4 and 8
     * samples a pixel, anisotropy 2, 4, 8 and 16.
     */
    public Quality onHardware() {
        if (equals(LOW)) {
            return onHardware(2, 2);
        } else if (equals(MEDIUM)) {
            return onHardware(4, 4);
        } else if (equals(HIGH)) {
            return onHardware(4, 8);
        }
        return equals(ULTRA) ? onHardware(8, 16) : this;
    }

    private Quality onHardware(int itsSamples, int itsAnisotropy) {
        return withSamples(itsSamples).withAnisotropy(itsAnisotropy).withUpscale(Upscale.EDGE_ADAPTIVE);
    }

    public Quality withPictureResolution(double share) {
        return with(draft -> draft.pictureResolution = share);
    }

    public Quality withUpscale(Upscale filter) {
        return with(draft -> draft.upscale = filter);
    }

    public Quality withAnisotropy(int texels) {
        return with(draft -> draft.anisotropy = texels);
    }

    public Quality withNormalMaps(NormalMaps maps) {
        return with(draft -> draft.normalMaps = maps);
    }

    public Quality withBrdf(ReflectionModel model) {
        return with(draft -> draft.brdf = model);
    }

    public Quality withShadowTexels(int texels) {
        return with(draft -> draft.shadowTexels = texels);
    }

    public Quality withShadowFilter(ShadowSampling sampling) {
        return with(draft -> draft.shadowFilter = sampling);
    }

    public Quality withLightShadows(int lights) {
        return with(draft -> draft.lightShadows = lights);
    }

    public Quality withSamples(int perPixel) {
        return with(draft -> draft.samples = perPixel);
    }

    public Quality withEdgeFilter(EdgeFilter filter) {
        return with(draft -> draft.edgeFilter = filter);
    }

    public Quality withCloudResolution(double share) {
        return with(draft -> draft.cloudResolution = share);
    }

    public Quality withCloudHistory(CloudHistory frames) {
        return with(draft -> draft.cloudHistory = frames);
    }

    public Quality withCloudStep(double cells) {
        return with(draft -> draft.cloudStep = cells);
    }

    public Quality withCloudLightCell(int edge) {
        return with(draft -> draft.cloudLightCell = edge);
    }

    public Quality withCloudScattering(CloudScattering model) {
        return with(draft -> draft.cloudScattering = model);
    }

    public Quality withBillboardFacing(BillboardFacing facing) {
        return with(draft -> draft.billboardFacing = facing);
    }

    public Quality withParticleLight(BallLight model) {
        return with(draft -> draft.particleLight = model);
    }

    public Quality withImpostors(ImpostorChoice clouds) {
        return with(draft -> draft.impostors = clouds);
    }

    public Quality withImpostorErrorPixels(double pixels) {
        return with(draft -> draft.impostorErrorPixels = pixels);
    }

    public Quality withSkyplaneShape(SkyplaneShape shape) {
        return with(draft -> draft.skyplaneShape = shape);
    }

    public Quality withProceduralNoise(ProceduralNoise noise) {
        return with(draft -> draft.proceduralNoise = noise);
    }

    public Quality withCloudSkyboxTexels(int texels) {
        return with(draft -> draft.cloudSkyboxTexels = texels);
    }

    public Quality withTerrainDetail(TerrainDetail triangles) {
        return with(draft -> draft.terrainDetail = triangles);
    }

    public Quality withTerrainErrorPixels(double pixels) {
        return with(draft -> draft.terrainErrorPixels = pixels);
    }

    public Quality withTerrainLayers(LayerMixing where) {
        return with(draft -> draft.terrainLayers = where);
    }

    public Quality withSpriteCoverage(SpriteCoverage coverage) {
        return with(draft -> draft.spriteCoverage = coverage);
    }

    public Quality withLightParts(LightParts parts) {
        return with(draft -> draft.lightParts = parts);
    }

    public Quality withImpostorPixels(double pixels) {
        return with(draft -> draft.impostorPixels = pixels);
    }

    public Quality withPortalTechnique(PortalTechnique technique) {
        return with(draft -> draft.portalTechnique = technique);
    }

    public Quality withViewBudget(int views) {
        return with(draft -> draft.viewBudget = views);
    }

    public Quality withPortalResolution(double share) {
        return with(draft -> draft.portalResolution = share);
    }

    private Quality with(Consumer<QualityDraft> change) {
        QualityDraft draft = new QualityDraft(this);
        change.accept(draft);
        return draft.quality();
    }
}
