/** Painters of clouds as seen from above, and of a grid of densities: {@link nephele.lab.art.cloud.CloudPictures}. */
package nephele.lab.art.cloud;
