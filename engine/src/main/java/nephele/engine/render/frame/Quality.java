package nephele.engine.render.frame;

/**
 * Settings that trade accuracy for speed.
 *
 * @param anisotropy greatest number of texture samples along the steepest direction
 * @param shadowTexels greatest length of the longer side of the sun's shadow map
 * @param samples greatest number of coverage samples a pixel; 1 draws without multisampling
 * @param portalTechnique technique of drawing a view through an opening
 * @param viewBudget greatest number of views through openings in a frame; the largest ones are drawn
 * @param portalResolution pixels of an opening's own picture along each side, as a share of the picture's; for TEXTURE
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

    /**
     * Returns the preset as a graphics card draws it, where samples and anisotropy cost little: 2, 4, 4 and 8 samples a
     * pixel, anisotropy 2, 4, 8 and 16.
     */
    public Quality onHardware() {
        if (equals(LOW)) {
            return withSamples(2).withAnisotropy(2);
        } else if (equals(MEDIUM)) {
            return withSamples(4).withAnisotropy(4);
        } else if (equals(HIGH)) {
            return withSamples(4).withAnisotropy(8);
        }
        return equals(ULTRA) ? withSamples(8).withAnisotropy(16) : this;
    }

    /** Returns this quality with another anisotropy. */
    public Quality withAnisotropy(int newAnisotropy) {
        return new Quality(newAnisotropy, shadowTexels, samples, portalTechnique, viewBudget, portalResolution);
    }

    public Quality withShadowTexels(int newTexels) {
        return new Quality(anisotropy, newTexels, samples, portalTechnique, viewBudget, portalResolution);
    }

    /** Returns this quality with another number of samples a pixel. */
    public Quality withSamples(int newSamples) {
        return new Quality(anisotropy, shadowTexels, newSamples, portalTechnique, viewBudget, portalResolution);
    }

    /** Returns this quality with another technique for views through openings. */
    public Quality withPortalTechnique(PortalTechnique newTechnique) {
        return new Quality(anisotropy, shadowTexels, samples, newTechnique, viewBudget, portalResolution);
    }

    /** Returns this quality with another view budget. */
    public Quality withViewBudget(int newBudget) {
        return new Quality(anisotropy, shadowTexels, samples, portalTechnique, newBudget, portalResolution);
    }

    /** Returns this quality with another resolution of openings' own pictures. */
    public Quality withPortalResolution(double newResolution) {
        return new Quality(anisotropy, shadowTexels, samples, portalTechnique, viewBudget, newResolution);
    }
}
