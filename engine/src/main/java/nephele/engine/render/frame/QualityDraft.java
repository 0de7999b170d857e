package nephele.engine.render.frame;

import nephele.engine.cloud.drawn.SkyplaneShape;
import nephele.engine.cloud.light.BallLight;
import nephele.engine.cloud.octave.ProceduralNoise;
import nephele.engine.render.frame.Quality.BillboardFacing;
import nephele.engine.render.frame.Quality.CloudHistory;
import nephele.engine.render.frame.Quality.CloudScattering;
import nephele.engine.render.frame.Quality.EdgeFilter;
import nephele.engine.render.frame.Quality.ImpostorChoice;
import nephele.engine.render.frame.Quality.LayerMixing;
import nephele.engine.render.frame.Quality.LightParts;
import nephele.engine.render.frame.Quality.NormalMaps;
import nephele.engine.render.frame.Quality.ReflectionModel;
import nephele.engine.render.frame.Quality.ShadowSampling;
import nephele.engine.render.frame.Quality.SpriteCoverage;
import nephele.engine.render.frame.Quality.TerrainDetail;
import nephele.engine.render.frame.Quality.Upscale;

/** The fields of a {@link Quality} that is being changed. */
final class QualityDraft {
    double pictureResolution;
    Upscale upscale;
    int anisotropy;
    NormalMaps normalMaps;
    ReflectionModel brdf;
    int shadowTexels;
    ShadowSampling shadowFilter;
    int lightShadows;
    int samples;
    EdgeFilter edgeFilter;
    double cloudResolution;
    CloudHistory cloudHistory;
    double cloudStep;
    int cloudLightCell;
    CloudScattering cloudScattering;
    BillboardFacing billboardFacing;
    BallLight particleLight;
    ImpostorChoice impostors;
    double impostorErrorPixels;
    SkyplaneShape skyplaneShape;
    ProceduralNoise proceduralNoise;
    int cloudSkyboxTexels;
    TerrainDetail terrainDetail;
    double terrainErrorPixels;
    LayerMixing terrainLayers;
    SpriteCoverage spriteCoverage;
    LightParts lightParts;
    double impostorPixels;
    PortalTechnique portalTechnique;
    int viewBudget;
    double portalResolution;

    QualityDraft(Quality from) {
        pictureResolution = from.pictureResolution();
        upscale = from.upscale();
        anisotropy = from.anisotropy();
        normalMaps = from.normalMaps();
        brdf = from.brdf();
        shadowTexels = from.shadowTexels();
        shadowFilter = from.shadowFilter();
        lightShadows = from.lightShadows();
        samples = from.samples();
        edgeFilter = from.edgeFilter();
        cloudResolution = from.cloudResolution();
        cloudHistory = from.cloudHistory();
        cloudStep = from.cloudStep();
        cloudLightCell = from.cloudLightCell();
        cloudScattering = from.cloudScattering();
        billboardFacing = from.billboardFacing();
        particleLight = from.particleLight();
        impostors = from.impostors();
        impostorErrorPixels = from.impostorErrorPixels();
        skyplaneShape = from.skyplaneShape();
        proceduralNoise = from.proceduralNoise();
        cloudSkyboxTexels = from.cloudSkyboxTexels();
        terrainDetail = from.terrainDetail();
        terrainErrorPixels = from.terrainErrorPixels();
        terrainLayers = from.terrainLayers();
        spriteCoverage = from.spriteCoverage();
        lightParts = from.lightParts();
        impostorPixels = from.impostorPixels();
        portalTechnique = from.portalTechnique();
        viewBudget = from.viewBudget();
        portalResolution = from.portalResolution();
    }

    Quality quality() {
        return new Quality(
                pictureResolution,
                upscale,
                anisotropy,
                normalMaps,
                brdf,
                shadowTexels,
                shadowFilter,
                lightShadows,
                samples,
                edgeFilter,
                cloudResolution,
                cloudHistory,
                cloudStep,
                cloudLightCell,
                cloudScattering,
                billboardFacing,
                particleLight,
                impostors,
                impostorErrorPixels,
                skyplaneShape,
                proceduralNoise,
                cloudSkyboxTexels,
                terrainDetail,
                terrainErrorPixels,
                terrainLayers,
                spriteCoverage,
                lightParts,
                impostorPixels,
                portalTechnique,
                viewBudget,
                portalResolution);
    }
}
