/** Painters of clouds as seen from above, and of a grid of densities: {@link nephele.workshop.art.cloud.CloudPictures}. */
package nephele.workshop.art.cloud;
