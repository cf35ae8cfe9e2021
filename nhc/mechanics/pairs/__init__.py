"""Two specs held against one another: do they describe the same motion?"""
