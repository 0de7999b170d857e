package nephele.engine.render.frame;

/**
 * What may be traded for speed.
 *
 * @param anisotropy texture samples along the steepest direction, at most
 * @param shadowTexels longer side of the sun's shadow map, at most
 * @param samples coverage samples a pixel, at most; 1 draws without multisampling
 * @param portalTechnique how what is seen through a portal gets into the picture
 * @param viewBudget views through portals that are drawn in a frame, at most; the largest are
 * @param portalResolution pixels of a portal's own picture along each side, as a share of the picture's; for TEXTURE
 */
public record Quality(
        int anisotropy,
        int shadowTexels,
        int samples,
        PortalTechnique portalTechnique,
        int viewBudget,
        double portalResolution) {
    public static final Quality LOW = new Quality(1, 1024, 1, PortalTechnique.STENCIL, 6, 1);
    public static final Quality MEDIUM = new Quality(1, 2048, 1, PortalTechnique.STENCIL, 9, 1);
    public static final Quality HIGH = new Quality(1, 4096, 1, PortalTechnique.STENCIL, 12, 1);
    public static final Quality ULTRA = new Quality(8, 4096, 4, PortalTechnique.STENCIL, 32, 1);

    public Quality withAnisotropy(int newAnisotropy) {
        return new Quality(newAnisotropy, shadowTexels, samples, portalTechnique, viewBudget, portalResolution);
    }

    public Quality withShadowTexels(int newTexels) {
        return new Quality(anisotropy, newTexels, samples, portalTechnique, viewBudget, portalResolution);
    }

    public Quality withSamples(int newSamples) {
        return new Quality(anisotropy, shadowTexels, newSamples, portalTechnique, viewBudget, portalResolution);
    }

    public Quality withPortalTechnique(PortalTechnique newTechnique) {
        return new Quality(anisotropy, shadowTexels, samples, newTechnique, viewBudget, portalResolution);
    }

    public Quality withViewBudget(int newBudget) {
        return new Quality(anisotropy, shadowTexels, samples, portalTechnique, newBudget, portalResolution);
    }

    public Quality withPortalResolution(double newResolution) {
        return new Quality(anisotropy, shadowTexels, samples, portalTechnique, viewBudget, newResolution);
    }
}
